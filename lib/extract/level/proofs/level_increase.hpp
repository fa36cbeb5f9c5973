// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "extract/level/level.hpp"
#include "extract/level/mode_forms.hpp"

namespace tensortopo {

/// Linear bounds on the norm sqrt(P) of a linear field on a simplex, in barycentric coordinates x:
/// lower * l <= sqrt(P) <= l with l = sum of upper_i x_i.
template <class Scalar, std::size_t Vertices>
struct NormBounds {
  std::array<Scalar, Vertices> upper{};
  Scalar lower{};             ///< at most one; 0 if the field may vanish
  bool inconclusive = false;  ///< lower is 0, but might not be with more precision
};

/// Bounds from the angles between vertex tensors: P = l^2 - sum of 2 x_i x_j n_i n_j (1 - cos_ij),
/// and the sum of x_i x_j n_i n_j over pairs is at most (1 - 1/Vertices) l^2 / 2.
///
/// They hold for the exact field. Room is left for its rounding (see `rounding_unit`) and for those
/// here: a norm is wrong by at most 16 of these units, a cosine by at most 30.
template <class Scalar, std::size_t Vertices>
NormBounds<Scalar, Vertices> norm_bounds(const ModeForms<Scalar, Vertices>& forms,
                                         double total = 1) {
  using std::sqrt;
  NormBounds<Scalar, Vertices> bounds;
  std::array<Scalar, Vertices> norm;
  Scalar least{};
  for (std::size_t i = 0, pair = 0; i < Vertices; pair += Vertices - i, ++i) {
    const Scalar& p = forms.norm.coefficients[pair];
    if (!(p > Scalar(0))) return bounds;
    norm[i] = sqrt(p);
    if (i == 0 || norm[i] < least) least = norm[i];
  }
  const Scalar room = Scalar(32) * rounding_unit(least, total);
  bounds.inconclusive = !(room < Scalar(0.125));
  if (bounds.inconclusive) return bounds;
  for (std::size_t i = 0; i < Vertices; ++i) bounds.upper[i] = norm[i] * (Scalar(1) + room);
  Scalar cosine(1);
  for (std::size_t i = 0, pair = 0; i < Vertices; ++i) {
    ++pair;
    for (std::size_t j = i + 1; j < Vertices; ++j, ++pair) {
      const Scalar c = forms.norm.coefficients[pair] / (Scalar(2) * norm[i] * norm[j]);
      if (c < cosine) cosine = c;
    }
  }
  constexpr double kPairs = 1 - 1.0 / static_cast<double>(Vertices);
  const Scalar square = Scalar(1) - Scalar(kPairs) * (Scalar(1) - cosine) - Scalar(4) * room;
  if (square > Scalar(0)) bounds.lower = sqrt(square) * (Scalar(1) - room);
  return bounds;
}

/// Quadratic forms below and above l sqrt(P): the chord (P + lower l^2) / (1 + lower) and the
/// tangent
/// (P + l^2) / 2 of the square root, both times l^2.
template <class Scalar, std::size_t Vertices>
struct RootBounds {
  BarycentricPolynomial<Scalar, Vertices, 1> l;
  BarycentricPolynomial<Scalar, Vertices, 2> chord, tangent;

  RootBounds(const ModeForms<Scalar, Vertices>& forms, const NormBounds<Scalar, Vertices>& bounds) {
    for (std::size_t i = 0; i < Vertices; ++i) l.coefficients[i] = bounds.upper[i];
    const auto square = l * l;
    const Scalar half = Scalar(1) / Scalar(2), share = Scalar(1) / (Scalar(1) + bounds.lower);
    tangent = half * (forms.norm + square);
    chord = share * (forms.norm + bounds.lower * square);
  }
};

/// A form of degree four that shows, if it is positive, that the mode is larger than mu (`above`),
/// if it is negative, that it is smaller: l (6 Q - sqrt(18) mu P sqrt(P)) with the bound of l
/// sqrt(P) that proves the less.
template <class Scalar, std::size_t Vertices>
BarycentricPolynomial<Scalar, Vertices, 4> side_form(const ModeForms<Scalar, Vertices>& forms,
                                                     const RootBounds<Scalar, Vertices>& root,
                                                     const Level<Scalar>& level, bool above) {
  const Scalar factor = Scalar(3) * level.sqrt2 * level.mu;
  return root.l * forms.determinant -
         factor * (forms.norm * ((level.mu > Scalar(0)) == above ? root.tangent : root.chord));
}

template <class Scalar, std::size_t Vertices>
BarycentricPolynomial<Scalar, Vertices, 4> side_form(const ModeForms<Scalar, Vertices>& forms,
                                                     const NormBounds<Scalar, Vertices>& bounds,
                                                     const Level<Scalar>& level, bool above) {
  return side_form(forms, RootBounds<Scalar, Vertices>(forms, bounds), level, above);
}

/// Derivative by one of the coordinates: as `derivative` along its unit vector, whose zeros cost
/// more than the rest.
template <class Scalar, std::size_t Vertices, std::size_t Degree>
BarycentricPolynomial<Scalar, Vertices, Degree - 1> partial_derivative(
    const BarycentricPolynomial<Scalar, Vertices, Degree>& p, std::size_t coordinate) {
  BarycentricPolynomial<Scalar, Vertices, Degree - 1> result;
  const auto& index = detail::kProduct<Vertices, Degree - 1, 1>;
  for (std::size_t i = 0; i < result.size; ++i) {
    const auto k = index[i][coordinate];
    result.coefficients[i] = Scalar(int{p.exponents[k][coordinate]}) * p.coefficients[k];
  }
  return result;
}

/// Two cubics for each vertex tensor, as coefficients side by side: combined with the weights d_i
/// of a direction, if all of them are positive then the mode increases along d at every point
/// of the level.
///
/// With R = 6 Q the mode is R / (sqrt(18) P^(3/2)), so on the level of mu it increases along d
/// where
///   2 d(R) - 3 sqrt(18) mu sqrt(P) d(P) > 0.
/// That is affine in sqrt(P). So it is enough that both cubics 2 l d(R) - 3 sqrt(18) mu q d(P) are
/// positive, with q one and the other of the `RootBounds`. (The form of degree four without mu, 2 P
/// d(R) - 3 R d(P), says the same of all levels at once, and is positive much more rarely.)
template <class Scalar, std::size_t Vertices>
struct LevelIncrease {
  using Cubic = BarycentricPolynomial<Scalar, Vertices, 3>;
  static constexpr std::size_t size = 2 * Cubic::size;

  /// Of each vertex: the coefficients of the chord's cubic, then those of the tangent's.
  std::array<std::array<Scalar, size>, Vertices> along;

  /// @param level  a `Level`, or what has its `mu` and `sqrt2` in the scalar
  template <class AnyLevel>
  LevelIncrease(const ModeForms<Scalar, Vertices>& forms,
                const NormBounds<Scalar, Vertices>& bounds, const AnyLevel& level)
      : LevelIncrease(forms, RootBounds<Scalar, Vertices>(forms, bounds), level) {}

  template <class AnyLevel>
  LevelIncrease(const ModeForms<Scalar, Vertices>& forms, const RootBounds<Scalar, Vertices>& root,
                const AnyLevel& level) {
    const Scalar factor = Scalar(9) * level.sqrt2 * level.mu;
    for (std::size_t i = 0; i < Vertices; ++i) {
      const Cubic rise = Scalar(2) * (root.l * partial_derivative(forms.determinant, i));
      const auto fall = factor * partial_derivative(forms.norm, i);
      const Cubic low = root.chord * fall, high = root.tangent * fall;
      for (std::size_t k = 0; k < Cubic::size; ++k) {
        along[i][k] = rise.coefficients[k] - low.coefficients[k];
        along[i][Cubic::size + k] = rise.coefficients[k] - high.coefficients[k];
      }
    }
  }

  LevelIncrease() = default;

  /// The coefficients for a direction.
  std::array<Scalar, size> operator()(const std::array<Scalar, Vertices>& d) const {
    std::array<Scalar, size> sum;
    for (std::size_t k = 0; k < size; ++k) sum[k] = d[0] * along[0][k];
    for (std::size_t i = 1; i < Vertices; ++i)
      for (std::size_t k = 0; k < size; ++k) sum[k] = sum[k] + d[i] * along[i][k];
    return sum;
  }
};

template <std::size_t Vertices>
const LevelIncrease<double, Vertices>& rounded(const LevelIncrease<double, Vertices>& increase) {
  return increase;
}

template <class Scalar, std::size_t Vertices>
LevelIncrease<double, Vertices> rounded(const LevelIncrease<Scalar, Vertices>& increase) {
  LevelIncrease<double, Vertices> result;
  for (std::size_t i = 0; i < Vertices; ++i)
    for (std::size_t k = 0; k < result.size; ++k)
      result.along[i][k] = static_cast<double>(increase.along[i][k]);
  return result;
}

}  // namespace tensortopo
