// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Angles: one step of Newton's method from what the C library gives. Its error is squared, so that
// the result does not depend on it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sine_cosine.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "to_nearest.hpp"

namespace tensortopo::elementary {

namespace {

/// A step of Newton's method, with a bound on what the errors of the sine and cosine add to it.
struct Step {
  double length = 0, error = 0;
};

/// The double nearest to the angle that Newton's method finds from `start`: with a sine and cosine
/// of few digits, if these decide the rounding, and else with all digits.
///
/// The error of the sum is that of the step, by its rounding less than 2^-30 of the step, and of
/// Newton's method, for functions whose second derivative is at most twice their first over the
/// angle.
/// @param at         of which angle the step takes sine and cosine
/// @param step_from  step_from(SineCosine): the step
/// @param otherwise  otherwise(): the result where neither decides
template <class StepFrom, class Otherwise>
double corrected(double start, double at, const StepFrom& step_from, const Otherwise& otherwise) {
  const auto with = [&](const SineCosine& digits, const auto& else_with) {
    const Step step = step_from(digits);
    // A C library that gives more than 12 wrong bits is not trusted at all.
    if (!(std::abs(step.length) <= 0x1p-40 * std::abs(start))) return otherwise();
    const double error = step.error + std::abs(start) * kRelativeError +
                         std::abs(step.length) * std::abs(step.length / start) * 4;
    return nearest_within(ordered_sum(start, step.length), error, else_with);
  };
  return with(sine_cosine_of_few_digits(at), [&] { return with(sine_cosine(at), otherwise); });
}

/// From sin^2(x) = square.
Step step_of_sine(const SineCosine& at, const DoubleDouble& square) {
  const DoubleDouble rest = square - at.sin * at.sin;
  return {rest.hi / (2 * at.sin.hi * at.cos.hi), 2 * at.sin_error / at.cos.hi};
}
/// From cos^2(x) = square.
Step step_of_cosine(const SineCosine& at, const DoubleDouble& square) {
  const DoubleDouble rest = at.cos * at.cos - square;
  return {rest.hi / (2 * at.sin.hi * at.cos.hi), 2 * at.cos_error / at.sin.hi};
}

}  // namespace

double asin(double x) {
  const auto otherwise = [x] {
    return std::abs(
        nearest_of([&](mpfr_ptr y) { return mpfr_asin(y, MpfrNumber(x).get(), MPFR_RNDZ); }));
  };
  if (std::abs(x) == 1) return std::copysign(std::numbers::pi / 2, x);
  if (!(std::abs(x) < 1) || std::abs(x) < 0x1p-400) return std::copysign(otherwise(), x);
  const double size = std::abs(x), start = std::asin(size);
  const auto step_from = [&](const SineCosine& at) -> Step {
    if (size >= 0.5) return step_of_cosine(at, (1 - size) * exact_sum(1, size));  // exact
    return {(DoubleDouble{size, 0} - at.sin).hi / at.cos.hi, 2 * at.sin_error};
  };
  return std::copysign(corrected(start, start, step_from, otherwise), x);
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
  const DoubleDouble square = 0.5 * exact_sum(1, -std::abs(x));
  const auto step_from = [&](const SineCosine& at) -> Step {
    const Step half = x > 0 ? step_of_sine(at, square) : step_of_cosine(at, square);
    return {2 * half.length, 2 * half.error};
  };
  return corrected(start, start / 2, step_from, otherwise);
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
  const auto step_from = [&](const SineCosine& at) -> Step {
    const DoubleDouble across = y * at.cos - x * at.sin, along = x * at.cos + y * at.sin;
    return {across.hi / along.hi,
            2 * (std::abs(y / along.hi) * at.cos_error + std::abs(x / along.hi) * at.sin_error)};
  };
  return corrected(start, start, step_from, otherwise);
}

}  // namespace tensortopo::elementary
