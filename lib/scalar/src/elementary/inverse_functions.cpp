// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Angles: one step of Newton's method, to twice the precision, from what the C library gives. Its
// error is squared, so that the result does not depend on it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sine_cosine.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "to_nearest.hpp"

namespace tensortopo::elementary {

namespace {

/// start + step, of which the error is that of `step` (less than 2^-30 of it) and of Newton's
/// method, for functions whose second derivative is at most twice their first over the angle.
template <class Otherwise>
double corrected(double start, double step, const Otherwise& otherwise) {
  // A C library that gives more than 12 wrong bits is not trusted at all.
  if (!(std::abs(step) <= 0x1p-40 * std::abs(start))) return otherwise();
  const double error =
      std::abs(start) * kRelativeError + std::abs(step) * std::abs(step / start) * 4;
  return nearest_within(ordered_sum(start, step), error, otherwise);
}

/// From sin^2(x) = square, for the half of an angle.
double step_of_sine(const SineCosine& at, const DoubleDouble& square) {
  const DoubleDouble rest = square - at.sin * at.sin;
  return rest.hi / (2 * at.sin.hi * at.cos.hi);
}
/// From cos^2(x) = square.
double step_of_cosine(const SineCosine& at, const DoubleDouble& square) {
  const DoubleDouble rest = at.cos * at.cos - square;
  return rest.hi / (2 * at.sin.hi * at.cos.hi);
}

}  // namespace

double asin(double x) {
  const auto otherwise = [x] {
    return nearest_of([&](mpfr_ptr y) { return mpfr_asin(y, MpfrNumber(x).get(), MPFR_RNDZ); });
  };
  if (std::abs(x) == 1) return std::copysign(std::numbers::pi / 2, x);
  if (!(std::abs(x) < 1) || std::abs(x) < 0x1p-400) return otherwise();
  const double start = std::asin(std::abs(x));
  const SineCosine at = sine_cosine(start);
  if (std::abs(x) < 0.5) {
    const DoubleDouble rest = DoubleDouble{std::abs(x), 0} - at.sin;
    return std::copysign(corrected(start, rest.hi / at.cos.hi, otherwise), x);
  }
  const double one_minus = 1 - std::abs(x);  // exact
  const DoubleDouble square = one_minus * exact_sum(1, std::abs(x));
  return std::copysign(
      corrected(start, step_of_cosine(at, square), [&] { return std::abs(otherwise()); }), x);
}

double acos(double x) {
  const auto otherwise = [x] {
    return nearest_of([&](mpfr_ptr y) { return mpfr_acos(y, MpfrNumber(x).get(), MPFR_RNDZ); });
  };
  if (x == 1) return 0;
  if (x == -1) return std::numbers::pi;
  if (!(std::abs(x) < 1)) return otherwise();
  // By half angles: cos(a) = 1 - 2 sin^2(a / 2) = 2 cos^2(a / 2) - 1.
  const double start = std::acos(x);
  const SineCosine at = sine_cosine(start / 2);
  const DoubleDouble square = 0.5 * exact_sum(1, -std::abs(x));
  return corrected(start, 2 * (x > 0 ? step_of_sine(at, square) : step_of_cosine(at, square)),
                   otherwise);
}

double atan(double x) { return atan2(x, 1); }

double atan2(double y, double x) {
  const auto otherwise = [x, y] {
    return nearest_of([&](mpfr_ptr angle) {
      return mpfr_atan2(angle, MpfrNumber(y).get(), MpfrNumber(x).get(), MPFR_RNDZ);
    });
  };
  if (y == 0 && x > 0) return y;
  const double size = std::max(std::abs(x), std::abs(y));
  if (!(size < 0x1p400) || !(size > 0x1p-400)) return otherwise();
  if (y == 0) return std::copysign(std::numbers::pi, y);
  if (x == 0) return std::copysign(std::numbers::pi / 2, y);
  const double start = std::atan2(y, x);
  if (!(std::abs(start) > 0x1p-200)) return otherwise();
  const SineCosine at = sine_cosine(start);
  const DoubleDouble across = y * at.cos - x * at.sin, along = x * at.cos + y * at.sin;
  return corrected(start, across.hi / along.hi, otherwise);
}

}  // namespace tensortopo::elementary
