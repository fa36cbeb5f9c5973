// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "extract/level/level.hpp"
#include "extract/level/mode_forms.hpp"
#include "extract/level/proofs/level_increase.hpp"
#include "extract/level/proofs/likely_direction.hpp"
#include "extract/level/proofs/screen.hpp"

namespace tensortopo {

/// What signs of coefficients prove about one level of the mode on one simplex.
///
/// - *Empty*: the level does not meet it.
/// - *Monotone*: the mode increases along a direction wherever the level is, so the level is a
///   graph across it: no closed piece, and at most one point on each line of that direction.
/// A simplex that is monotone, whose edges hold at most one root each and whose faces are
/// monotone (in a direction of their own) or empty, holds the level as marching tetrahedra mesh
/// it: a disc that separates the vertices above from those below, or nothing.
template <class Scalar, std::size_t Vertices>
struct SimplexProof {
  enum class Kind { none, empty, monotone } kind = Kind::none;
  /// If monotone: the tensor sum D of these is the direction. (Where T + k D crosses the level, its
  /// mode increases with k; seen in the simplex, these are lines through one point outside, at
  /// infinity if the sum is zero.)
  std::array<Scalar, Vertices> direction{};
  bool inconclusive = false;  ///< kind is none, but more precision may prove more
};

namespace detail {

/// Whether all Bernstein coefficients have the sign given: positive if they do, negative if one
/// certainly does not, unknown if rounding may decide. `bound` is the error of a Bernstein
/// coefficient.
template <class Polynomial, class Scalar>
Verdict has_strict_sign(const Polynomial& p, int sign, const Scalar& bound) {
  Verdict verdict = Verdict::positive;
  for (std::size_t i = 0; i < p.size; ++i) {
    const Scalar limit = Scalar(p.multinomials[i]) * bound;
    const Scalar c = sign > 0 ? p.coefficients[i] : -p.coefficients[i];
    if (c < -limit) return Verdict::negative;
    if (!(c > limit)) verdict = Verdict::unknown;
  }
  return verdict;
}

/// Whether the Bernstein coefficients of a polynomial on an edge change their sign at most once:
/// positive if they do, negative if they certainly change it more often. `bound` as above.
template <class Polynomial, class Scalar>
Verdict changes_at_most_once(const Polynomial& p, const Scalar& bound) {
  int changes = 0, last = 0;
  bool certain = true;
  for (std::size_t i = 0; i < p.size; ++i) {
    const Scalar limit = Scalar(p.multinomials[i]) * bound;
    const auto& c = p.coefficients[i];
    const int sign = c > limit ? 1 : c < -limit ? -1 : 0;
    if (sign == 0) {
      certain = false;
      continue;
    }
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  if (changes > 1) return Verdict::negative;
  return certain ? Verdict::positive : Verdict::unknown;
}

/// Bounds on the rounding error of Bernstein coefficients, in units of `rounding_unit`, for a
/// largest vertex norm N = sqrt(P) of one. Evaluated in absolute values,
/// - a polar form P(S, T) stays below 3 N^2: its diagonal part below three times that of P;
/// - a polar adjugate of S, T stays below 2 |S| |T| in Frobenius norm (each of its nine entries
///   sums four products, each product occurs in one entry only), so one of 6 Q stays below
///   2 (sqrt(3) N)^3 < 10.4 N^3;
/// - of the cubics of `LevelIncrease` along d, |d_i| <= 1: 2 * 3 * (4 * 10.4) + 9 sqrt(2) * 3 * (2
///   * 4 * 3) = 1166 N^4;
/// - of `side_form`: 10.4 + 3 sqrt(2) * 3 * 3 = 49 N^4;
/// - of the form of degree 6: 10.4^2 + 18 * 3^3 = 595 N^6.
/// A result passes through at most 20 roundings for 6 Q and 50 for the forms made of it.
inline constexpr double kDeterminantBound = 20 * 10.4;
inline constexpr double kIncreaseBound = 50 * 1166;
inline constexpr double kSideBound = 50 * 49;
inline constexpr double kGeneralizedBound = 50 * 595;

/// Positive if the level is proved not to meet the simplex, unknown if rounding hides it. `root`:
/// from these bounds, if they are there already.
template <class Scalar, std::size_t Vertices>
Verdict is_empty(const ModeForms<Scalar, Vertices>& forms,
                 const NormBounds<Scalar, Vertices>& bounds, const Level<Scalar>& level,
                 const Scalar& norm, double total,
                 const RootBounds<Scalar, Vertices>* root = nullptr) {
  const Scalar u = rounding_unit(norm, total), cube = norm * norm * norm;
  const Verdict opposite =
      has_strict_sign(forms.determinant, -level.sign, Scalar(kDeterminantBound) * u * cube);
  if (opposite == Verdict::positive) return opposite;
  Verdict strict = Verdict::unknown;
  if (bounds.lower > Scalar(0)) {
    const Scalar &q = forms.determinant.coefficients[0], &p = forms.norm.coefficients[0];
    const bool above = q > Scalar(3) * level.sqrt2 * level.mu * p * bounds.upper[0];
    const auto form = root != nullptr ? side_form(forms, *root, level, above)
                                      : side_form(forms, bounds, level, above);
    strict = has_strict_sign(form, above ? 1 : -1, Scalar(kSideBound) * u * cube * norm);
  } else if (!bounds.inconclusive) {
    const auto form = generalized_mode_form(forms, level.mu_squared);
    const int sign = form.coefficients[0] > Scalar(0) ? 1 : -1;
    strict = has_strict_sign(form, sign, Scalar(kGeneralizedBound) * u * cube * cube);
  }
  return strict == Verdict::negative && opposite == Verdict::unknown ? opposite : strict;
}

/// Whether there is a direction, and its lines meet outside the simplex, so that none of them ends
/// inside.
template <class Scalar, std::size_t Vertices>
bool meets_outside(const std::array<Scalar, Vertices>& d) {
  std::size_t up = 0, down = 0;
  for (const auto& x : d) up += x > Scalar(0), down += x < Scalar(0);
  return up < Vertices && down < Vertices && up + down > 0;
}

/// Positive if it is proved that the mode increases along d wherever the level meets the simplex,
/// unknown if rounding hides it.
template <class Scalar, std::size_t Vertices>
Verdict increases_along(const LevelIncrease<Scalar, Vertices>& increase,
                        const std::array<Scalar, Vertices>& d, const Scalar& norm, double total) {
  using Cubic = typename LevelIncrease<Scalar, Vertices>::Cubic;
  const Scalar bound =
      Scalar(kIncreaseBound) * rounding_unit(norm, total) * norm * norm * norm * norm;
  const auto coefficients = increase(d);
  Verdict verdict = Verdict::positive;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    const Scalar limit = Scalar(Cubic::multinomials[k % Cubic::size]) * bound;
    if (coefficients[k] < -limit) return Verdict::negative;
    if (!(coefficients[k] > limit)) verdict = Verdict::unknown;
  }
  return verdict;
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

/// Whether the level seems to pass between the vertices. Not certain, and need not be: it only
/// saves the search for a proof of the contrary, which `prove_part` makes up for where rounding
/// decides.
template <std::size_t Vertices>
bool is_crossed(const std::array<Deviator<double>, Vertices>& tensors, double mu) {
  bool above = false, below = false;
  for (const auto& t : tensors) {
    const double p = norm_form(t);
    (1.4142135623730951 * determinant_form(t) > mu * p * std::sqrt(p) ? above : below) = true;
  }
  return above && below;
}

/// How long to search for a direction: in all of a triangle or tetrahedron of the mesh, where that
/// saves a refinement, and in a part.
inline constexpr int kLongSearch = 100, kShortSearch = 20;

/// Tries the proofs above on a triangle or a tetrahedron.
///
/// @param total  as in `rounding_unit`, the largest of a vertex
/// @param steps  how long to search for a direction
template <class Scalar, std::size_t Vertices>
SimplexProof<Scalar, Vertices> prove_simplex(const std::array<Deviator<Scalar>, Vertices>& tensors,
                                             const Level<Scalar>& level, double total = 1,
                                             int steps = kLongSearch) {
  using Proof = SimplexProof<Scalar, Vertices>;
  Proof proof;
  const auto in_double = rounded(tensors);
  const bool crossed = is_crossed(in_double, static_cast<double>(level.mu));
  if (!crossed && screen::excludes(in_double, level.lode_angle)) {
    proof.kind = Proof::Kind::empty;
    return proof;
  }
  const Scalar norm = largest_norm(tensors);
  if (!(norm > Scalar(0))) return proof;
  const auto forms = mode_forms(tensors);
  const auto bounds = norm_bounds(forms, total);
  std::optional<RootBounds<Scalar, Vertices>> root;
  if (bounds.lower > Scalar(0)) root.emplace(forms, bounds);
  // A direction takes longer to find than an uncrossed simplex to be proved empty.
  const Verdict empty =
      crossed ? Verdict::negative
              : detail::is_empty(forms, bounds, level, norm, total, root ? &*root : nullptr);
  if (empty == Verdict::positive) {
    proof.kind = Proof::Kind::empty;
    return proof;
  }
  Verdict increases = bounds.inconclusive ? Verdict::unknown : Verdict::negative;
  if (root) {
    const LevelIncrease<Scalar, Vertices> increase(forms, *root, level);
    for (const bool of_sum_zero : {false, true}) {
      if (!of_sum_zero && !crossed) continue;
      const auto direction = likely_direction(rounded(increase), steps, of_sum_zero);
      for (std::size_t i = 0; i < Vertices; ++i) proof.direction[i] = Scalar(direction[i]);
      if (!detail::meets_outside(proof.direction)) continue;
      increases = detail::increases_along(increase, proof.direction, norm, total);
      break;
    }
    if (increases == Verdict::positive) {
      proof.kind = Proof::Kind::monotone;
      return proof;
    }
  }
  proof.inconclusive = increases == Verdict::unknown || empty == Verdict::unknown;
  return proof;
}

/// Whether signs of coefficients alone prove that the level does not meet the simplex; `total` as
/// in `rounding_unit`.
template <class Scalar, std::size_t Vertices>
bool is_proved_empty(const std::array<Deviator<Scalar>, Vertices>& tensors,
                     const Level<Scalar>& level, double total = 1) {
  const Scalar norm = largest_norm(tensors);
  if (!(norm > Scalar(0))) return false;
  const auto forms = mode_forms(tensors);
  return detail::is_empty(forms, norm_bounds(forms, total), level, norm, total) ==
         Verdict::positive;
}

/// Positive if it is proved that an edge holds at most one point of the level: the mode is monotone
/// along it, or the degree-six form changes sign at most once (Descartes). Unknown if rounding
/// hides it.
template <class Scalar>
Verdict has_at_most_one_crossing(const std::array<Deviator<Scalar>, 2>& tensors,
                                 const Level<Scalar>& level, double total = 1) {
  const auto in_double = rounded(tensors);
  if (!is_crossed(in_double, static_cast<double>(level.mu)) &&
      screen::excludes(in_double, level.lode_angle))
    return Verdict::positive;
  const Scalar norm = largest_norm(tensors);
  if (!(norm > Scalar(0))) return Verdict::negative;
  const auto forms = mode_forms(tensors);
  const Scalar u = rounding_unit(norm, total), n2 = norm * norm;
  const auto bounds = norm_bounds(forms, total);
  Verdict monotone = bounds.inconclusive ? Verdict::unknown : Verdict::negative;
  if (bounds.lower > Scalar(0)) {
    const LevelIncrease<Scalar, 2> increase(forms, bounds, level);
    const Scalar up(increase.along[1][0] > increase.along[0][0] ? 1 : -1);
    monotone = detail::increases_along(increase, {-up, up}, norm, total);
    if (monotone == Verdict::positive) return monotone;
  }
  // The level of mode 0 is where the determinant vanishes, once; the form of degree six has double
  // roots there.
  const Verdict descartes =
      level.mu_squared == Scalar(0)
          ? detail::changes_at_most_once(forms.determinant,
                                         Scalar(detail::kDeterminantBound) * u * n2 * norm)
          : detail::changes_at_most_once(generalized_mode_form(forms, level.mu_squared),
                                         Scalar(detail::kGeneralizedBound) * u * n2 * n2 * n2);
  return descartes == Verdict::negative && monotone == Verdict::unknown ? monotone : descartes;
}

}  // namespace tensortopo
