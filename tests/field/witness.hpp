// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/field/linear_field.hpp"

namespace tensortopo::witness {

/// A linear field T0 + x Tx + y Ty + z Tz with exact rational entries: numerators in the order xx,
/// xy, xz, yy, yz, zz and one denominator for each of the four tensors.
struct Field {
  const char* name;
  int rank;
  long numerator[4][6];
  long denominator[4] = {1, 1, 1, 1};
};

inline constexpr Field saddle_origin = {
    "saddle_origin",
    4,
    {{4, 0, 0, -5, 0, 1}, {0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}}};
inline constexpr Field saddle_origin_rational = {
    "saddle_origin_rational",
    4,
    {{11, 0, 0, -13, 0, 2}, {0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}}};
inline constexpr Field c1_loop = {
    "C1_loop",
    4,
    {{0, 0, -1, 0, 0, 0}, {4, 0, -2, -5, 0, 1}, {0, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0}}};
inline constexpr Field mubar_minus1 = {
    "mubar_minus1",
    4,
    {{0, 1, 0, 0, 0, 0}, {1, 0, 0, -1, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}}};
inline constexpr Field mubar_0 = {
    "mubar_0",
    4,
    {{0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}, {1, 0, 0, -2, 0, 1}}};
inline constexpr Field generic_1 = {
    "generic_1",
    4,
    {{1, -1, 2, 0, 1, -1}, {0, 2, 1, -1, 1, 1}, {2, 1, 0, -1, -2, -1}, {-1, 0, 1, 2, 1, -1}}};
inline constexpr Field rank3_translation = {
    "rank3_translation",
    3,
    {{0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 0}}};
inline constexpr Field rank3_translation_oblique = {
    "rank3_translation_oblique",
    3,
    {{0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 1, 0, 2, 0}}};
inline constexpr Field rank3_cone = {
    "rank3_cone",
    3,
    {{-1, -1, -1, -1, -1, 2}, {1, 0, 0, 1, 0, -2}, {0, 1, 0, 1, 1, -1}, {0, 0, 1, -1, 0, 1}},
    {4, 1, 1, 1}};
inline constexpr Field rank3_plane_strain = {
    "rank3_plane_strain",
    3,
    {{1, 0, 0, 1, 0, -2}, {1, 0, 0, -1, 0, 0}, {0, 1, 0, 0, 0, 0}, {1, 0, 0, 2, 0, -3}}};
inline constexpr Field rank2 = {
    "rank2",
    2,
    {{1, 0, 0, 1, 0, -2}, {0, 1, 0, 0, 0, 0}, {1, 1, 0, 1, 0, -2}, {2, 3, 0, 2, 0, -4}}};
inline constexpr Field rank1 = {
    "rank1",
    1,
    {{1, 0, 0, 0, 0, -1}, {2, 0, 0, 0, 0, -2}, {-1, 0, 0, 0, 0, 1}, {3, 0, 0, 0, 0, -3}}};
inline constexpr Field rank0 = {"rank0", 0, {}};
inline constexpr Field constant_exact_mode = {"constant_exact_mode", 1, {{11, 0, 0, 2, 0, -13}}};
inline constexpr Field antiplane_shear = {
    "antiplane_shear",
    2,
    {{0, 0, 1, 0, 2, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 1, 0, -1, 0}}};
inline constexpr Field near_deficient = {
    "near_deficient",
    4,
    {{0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}, {4, 0, 1000000000, -5, 0, 1}},
    {1, 1, 1, 1000000000}};

inline constexpr Field all[] = {saddle_origin,
                                saddle_origin_rational,
                                c1_loop,
                                mubar_minus1,
                                mubar_0,
                                generic_1,
                                rank3_translation,
                                rank3_translation_oblique,
                                rank3_cone,
                                rank3_plane_strain,
                                rank2,
                                rank1,
                                rank0,
                                constant_exact_mode,
                                antiplane_shear,
                                near_deficient};
/// The fields of rank 4 whose characteristic tensor is generic or special, each way once.
inline constexpr Field full_rank[] = {
    saddle_origin, saddle_origin_rational, c1_loop, mubar_minus1, mubar_0, generic_1};

template <class Scalar>
SymmetricTensor<Scalar> tensor(const long (&n)[6], long denominator) {
  const auto entry = [&](int i) { return Scalar(Scalar(n[i]) / Scalar(denominator)); };
  return {entry(0), entry(3), entry(5), entry(1), entry(4), entry(2)};
}

/// The tensors at the vertices (0,0,0), (1,0,0), (0,1,0), (0,0,1).
template <class Scalar>
std::array<SymmetricTensor<Scalar>, 4> unit_tetrahedron_tensors(const Field& f) {
  const auto t0 = tensor<Scalar>(f.numerator[0], f.denominator[0]);
  return {t0, t0 + tensor<Scalar>(f.numerator[1], f.denominator[1]),
          t0 + tensor<Scalar>(f.numerator[2], f.denominator[2]),
          t0 + tensor<Scalar>(f.numerator[3], f.denominator[3])};
}

template <class Scalar>
TetrahedronField<Scalar> unit_tetrahedron(const Field& f) {
  const auto t = unit_tetrahedron_tensors<Scalar>(f);
  return {{deviator(t[0]), deviator(t[1]), deviator(t[2]), deviator(t[3])}};
}

}  // namespace tensortopo::witness
