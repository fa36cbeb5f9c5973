// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/tensor/mode.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {
namespace {

/// The deviator times a power of two that brings its largest coordinate into [1/2, 1); zero stays.
template <class Scalar>
Deviator<Scalar> scaled_to_one(const Deviator<Scalar>& d) {
  using std::abs;
  using std::frexp;
  using std::ldexp;
  Scalar largest(0);
  for (const Scalar& x : {d.a, d.b, d.xy, d.yz, d.xz})
    if (abs(x) > largest) largest = abs(x);
  int exponent = 0;
  frexp(largest, &exponent);
  const auto scaled = [&](const Scalar& x) { return Scalar(ldexp(x, -exponent)); };
  return {scaled(d.a), scaled(d.b), scaled(d.xy), scaled(d.yz), scaled(d.xz)};
}

}  // namespace

template <RealScalar Scalar>
Scalar mode(const Deviator<Scalar>& d) {
  using std::sqrt;
  const Deviator<Scalar> t = scaled_to_one(d);
  const Scalar p = norm_form(t);
  const Scalar quotient = sqrt(Scalar(2)) * determinant_form(t) / (p * sqrt(p));
  return clamped(quotient, Scalar(-1), Scalar(1));
}

template <RealScalar Scalar>
std::optional<Scalar> mode_if_defined(const Deviator<Scalar>& d) {
  if (d == Deviator<Scalar>{}) return std::nullopt;
  return mode(d);
}

template <RealScalar Scalar>
Scalar lode_angle(const Deviator<Scalar>& d) {
  using elementary::atan2;
  using std::sqrt;
  const Deviator<Scalar> t = scaled_to_one(d);
  const Scalar sine = sqrt(Scalar(27) * discriminant_form(t));
  return atan2(sine, determinant_form(t)) / Scalar(3);
}

template <RealScalar Scalar>
std::array<Scalar, 5> orthonormal_coordinates(const Deviator<Scalar>& d) {
  using std::sqrt;
  const Scalar root2 = sqrt(Scalar(2)), root6 = sqrt(Scalar(6));
  return {d.a / root2, (d.a + d.b + d.b) / root6, root2 * d.xy, root2 * d.yz, root2 * d.xz};
}

template <RealScalar Scalar>
Deviator<Scalar> from_orthonormal_coordinates(const std::array<Scalar, 5>& x) {
  using std::sqrt;
  const Scalar root2 = sqrt(Scalar(2)), root6 = sqrt(Scalar(6));
  const Scalar a = root2 * x[0];
  return {a, (root6 * x[1] - a) / Scalar(2), x[2] / root2, x[3] / root2, x[4] / root2};
}

template <RealScalar Scalar>
Scalar angle_between(const Deviator<Scalar>& s, const Deviator<Scalar>& t) {
  using elementary::atan2;
  using std::sqrt;
  // Kahan: 2 atan(|u - v| / |u + v|) of the unit vectors.
  const auto unit = [](const Deviator<Scalar>& d) {
    const Deviator<Scalar> scaled = scaled_to_one(d);
    return Scalar(Scalar(1) / sqrt(norm_form(scaled))) * scaled;
  };
  const Deviator<Scalar> u = unit(s), v = unit(t);
  return Scalar(2) * atan2(Scalar(sqrt(norm_form(u - v))), Scalar(sqrt(norm_form(u + v))));
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                             \
  template Scalar mode(const Deviator<Scalar>&);                                   \
  template std::optional<Scalar> mode_if_defined(const Deviator<Scalar>&);         \
  template Scalar lode_angle(const Deviator<Scalar>&);                             \
  template Scalar angle_between(const Deviator<Scalar>&, const Deviator<Scalar>&); \
  template std::array<Scalar, 5> orthonormal_coordinates(const Deviator<Scalar>&); \
  template Deviator<Scalar> from_orthonormal_coordinates(const std::array<Scalar, 5>&);
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
