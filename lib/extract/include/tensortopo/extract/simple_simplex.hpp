// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "tensortopo/extract/level.hpp"
#include "tensortopo/extract/mode_forms.hpp"
#include "tensortopo/extract/screen.hpp"

namespace tensortopo {

/// What signs of coefficients prove about one level of the mode on one simplex.
///
/// - *Empty*: the level does not meet it.
/// - *Monotone*: the mode increases along a direction, so the level is a graph across it: no
///   closed piece, and at most one point on each line of that direction.
/// A simplex that is monotone, whose edges hold at most one root each and whose faces are
/// monotone (in a direction of their own) or empty, holds the level as marching tetrahedra draw
/// it: a disc that separates the vertices above from those below, or nothing.
template <class Scalar, std::size_t Vertices>
struct SimplexProof {
  enum class Kind { none, empty, monotone } kind = Kind::none;
  std::array<Scalar, Vertices> direction{};  ///< barycentric, sums to zero; if monotone
};

namespace detail {

/// True if all coefficients are above (sign > 0) or below (sign < 0) the error bound.
template <class Polynomial, class Scalar>
bool has_strict_sign(const Polynomial& p, int sign, const Scalar& bound) {
  for (const auto& c : p.coefficients)
    if (!(sign > 0 ? c > bound : c < -bound)) return false;
  return true;
}

/// The error bounds. With N^2 the largest P of the vertices, |P_ij| <= N^2 and the polar forms of
/// 6 Q are at most 6 N^3 / sqrt(2) in value; evaluated in absolute values they stay below 190 N^3.
/// No coefficient passes through more than 60 roundings. Summing products of absolute values:
/// 6 Q: multinomial 6 * 190; the form of degree 4, |d| <= 1: below 1.5e6 N^5; of degree 6: below
/// 1.2e7 N^6. The constants include the 60 roundings.
inline constexpr double kDeterminantBound = 7e4;
inline constexpr double kIncreaseBound = 9e7;
inline constexpr double kGeneralizedBound = 7.2e8;

template <class Scalar, std::size_t Vertices>
bool is_empty(const ModeForms<Scalar, Vertices>& forms, const Level<Scalar>& level,
              const Scalar& norm) {
  const Scalar u = rounding_unit(norm), cube = norm * norm * norm;
  if (has_strict_sign(forms.determinant, -level.sign, Scalar(kDeterminantBound) * u * cube))
    return true;
  const auto form = generalized_mode_form(forms, level.mu_squared);
  const Scalar bound = Scalar(kGeneralizedBound) * u * cube * cube;
  const int sign = form.coefficients[0] > Scalar(0) ? 1 : -1;
  return has_strict_sign(form, sign, bound);
}

template <class Scalar, std::size_t Vertices>
bool increases_along(const ModeForms<Scalar, Vertices>& forms,
                     const std::array<Scalar, Vertices>& d, const Scalar& norm) {
  const Scalar bound =
      Scalar(kIncreaseBound) * rounding_unit(norm) * norm * norm * norm * norm * norm;
  return has_strict_sign(mode_increase_form(forms, d), 1, bound);
}

/// Gradient of the mode at the centroid, as a barycentric direction of largest entry one.
template <class Scalar, std::size_t Vertices>
std::array<Scalar, Vertices> central_direction(
    const std::array<Deviator<Scalar>, Vertices>& tensors) {
  Deviator<Scalar> centre = tensors[0];
  for (std::size_t i = 1; i < Vertices; ++i) centre = centre + tensors[i];
  const auto m = thrice(centre);
  const auto adjugate = polar_adjugate(m, m);
  const Scalar p = norm_form(centre), q3 = inner(adjugate, m) / Scalar(2);
  std::array<Scalar, Vertices> d;
  Scalar mean(0);
  for (std::size_t i = 0; i < Vertices; ++i) {
    // 2 P dQ - 3 Q dP, up to a factor.
    d[i] = p * inner(adjugate, thrice(tensors[i])) -
           Scalar(2) * q3 * norm_form(centre, tensors[i]);
    mean = mean + d[i];
  }
  mean = mean / Scalar(static_cast<int>(Vertices));
  Scalar largest(0);
  for (auto& x : d) {
    x = x - mean;
    const Scalar size = x < Scalar(0) ? -x : x;
    if (size > largest) largest = size;
  }
  if (largest > Scalar(0))
    for (auto& x : d) x = x / largest;
  return d;
}

}  // namespace detail

/// Largest norm sqrt(P) of the vertex tensors.
template <class Scalar, std::size_t Vertices>
Scalar largest_norm(const std::array<Deviator<Scalar>, Vertices>& tensors) {
  using std::sqrt;
  Scalar largest(0);
  for (const auto& t : tensors) {
    const Scalar p = norm_form(t);
    if (p > largest) largest = p;
  }
  return sqrt(largest);
}

template <class Scalar, std::size_t Vertices>
std::array<Deviator<double>, Vertices> rounded(
    const std::array<Deviator<Scalar>, Vertices>& tensors) {
  std::array<Deviator<double>, Vertices> result;
  for (std::size_t i = 0; i < Vertices; ++i) {
    const auto& t = tensors[i];
    result[i] = {static_cast<double>(t.a), static_cast<double>(t.b), static_cast<double>(t.xy),
                 static_cast<double>(t.yz), static_cast<double>(t.xz)};
  }
  return result;
}

/// Tries the proofs above on a triangle or a tetrahedron.
template <class Scalar, std::size_t Vertices>
SimplexProof<Scalar, Vertices> prove_simplex(
    const std::array<Deviator<Scalar>, Vertices>& tensors, const Level<Scalar>& level) {
  using Proof = SimplexProof<Scalar, Vertices>;
  Proof proof;
  if (screen::excludes(rounded(tensors), level.lode_angle)) {
    proof.kind = Proof::Kind::empty;
    return proof;
  }
  const Scalar norm = largest_norm(tensors);
  if (!(norm > Scalar(0))) return proof;
  const auto forms = mode_forms(tensors);
  proof.direction = detail::central_direction(tensors);
  if (detail::increases_along(forms, proof.direction, norm))
    proof.kind = Proof::Kind::monotone;
  else if (detail::is_empty(forms, level, norm))
    proof.kind = Proof::Kind::empty;
  return proof;
}

/// True if it is proved that an edge holds at most one point of the level: the mode is monotone
/// along it, or the degree-six form has at most one sign change (Descartes), or none at all.
template <class Scalar>
bool has_at_most_one_crossing(const std::array<Deviator<Scalar>, 2>& tensors,
                              const Level<Scalar>& level) {
  if (screen::excludes(rounded(tensors), level.lode_angle)) return true;
  const Scalar norm = largest_norm(tensors);
  if (!(norm > Scalar(0))) return false;
  const auto forms = mode_forms(tensors);
  const std::array<Scalar, 2> along{Scalar(-1), Scalar(1)};
  const Scalar u = rounding_unit(norm), n2 = norm * norm;
  const auto increase = mode_increase_form(forms, along);
  const Scalar bound = Scalar(detail::kIncreaseBound) * u * n2 * n2 * norm;
  if (detail::has_strict_sign(increase, 1, bound) || detail::has_strict_sign(increase, -1, bound))
    return true;
  const auto form = generalized_mode_form(forms, level.mu_squared);
  const Scalar uncertain = Scalar(detail::kGeneralizedBound) * u * n2 * n2 * n2;
  int changes = 0, last = 0;
  for (const auto& c : form.coefficients) {
    const int sign = c > uncertain ? 1 : c < -uncertain ? -1 : 0;
    if (sign == 0) return false;
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  return changes <= 1;
}

}  // namespace tensortopo
