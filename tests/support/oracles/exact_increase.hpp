// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "extract/level/proofs/level_increase.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::test {

/// The sign of a + b sqrt(2), given a and a + b.
inline int sign_with_root_two(const Rational& a, const Rational& sum) {
  const Rational b = sum - a, difference = a * a - 2 * b * b;
  if (a == 0 && b == 0) return 0;
  if (a >= 0 && b >= 0) return 1;
  if (a <= 0 && b <= 0) return -1;
  return (difference > 0) == (a > 0) ? 1 : -1;
}

template <std::size_t Vertices>
NormBounds<Rational, Vertices> exact(const NormBounds<double, Vertices>& bounds) {
  NormBounds<Rational, Vertices> result;
  for (std::size_t i = 0; i < Vertices; ++i) result.upper[i] = Rational(bounds.upper[i]);
  result.lower = Rational(bounds.lower);
  return result;
}

/// Whether all coefficients of `side_form` have the sign that they should, for the field of these
/// exact forms, exact mode and these bounds.
template <std::size_t Vertices>
bool truly_on_side(const ModeForms<Rational, Vertices>& forms,
                   const NormBounds<double, Vertices>& bounds, const Rational& mu, bool above) {
  Level<Rational> level;
  level.mu = mu;
  level.sqrt2 = 0;
  // With sqrt(2) left out the sign of mu must still choose the same bound.
  const auto a = side_form(forms, exact(bounds), level, above);
  level.sqrt2 = 1;
  const auto sum = side_form(forms, exact(bounds), level, above);
  for (std::size_t k = 0; k < a.size; ++k)
    if (sign_with_root_two(a.coefficients[k], sum.coefficients[k]) != (above ? 1 : -1))
      return false;
  return true;
}

/// Whether the coefficients of `side_form`, or where the bounds say nothing of the form of degree
/// six, show that the level is not met.
template <std::size_t Vertices>
bool truly_empty(const ModeForms<Rational, Vertices>& forms,
                 const NormBounds<double, Vertices>& bounds, const Rational& mu) {
  if (bounds.lower > 0)
    return truly_on_side(forms, bounds, mu, true) || truly_on_side(forms, bounds, mu, false);
  const auto form = generalized_mode_form(forms, Rational(mu * mu));
  for (const int sign : {-1, 1}) {
    bool all = true;
    for (const auto& c : form.coefficients) all &= sign * c > 0;
    if (all) return true;
  }
  return false;
}

/// Whether all coefficients of `LevelIncrease` are positive along a direction, for the field of
/// these exact forms, exact mode and these bounds: in rationals, as numbers a + b sqrt(2).
template <std::size_t Vertices>
bool truly_increases(const ModeForms<Rational, Vertices>& forms,
                     const NormBounds<double, Vertices>& bounds, const Rational& mu,
                     const std::array<double, Vertices>& direction) {
  std::array<Rational, Vertices> exact_direction;
  for (std::size_t i = 0; i < Vertices; ++i) exact_direction[i] = Rational(direction[i]);
  const auto exact_bounds = exact(bounds);
  Level<Rational> level;
  level.mu = mu;
  level.sqrt2 = 0;
  const auto a = LevelIncrease<Rational, Vertices>(forms, exact_bounds, level)(exact_direction);
  level.sqrt2 = 1;
  const auto sum = LevelIncrease<Rational, Vertices>(forms, exact_bounds, level)(exact_direction);
  for (std::size_t k = 0; k < a.size(); ++k)
    if (sign_with_root_two(a[k], sum[k]) <= 0) return false;
  return true;
}

}  // namespace tensortopo::test
