// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "sine_cosine.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "tensortopo/scalar/elementary.hpp"
#include "to_nearest.hpp"

namespace tensortopo::elementary {

namespace {

/// Steps of pi/16 in a full turn.
constexpr int kAngleSteps = 32;
constexpr double kStepsPerRadian = 5.0929581789406507;

struct AngleTables {
  AngleTables() {
    MpfrNumber rest(mpfr_prec_t{400});
    mpfr_const_pi(rest.get(), MPFR_RNDN);
    mpfr_div_2ui(rest.get(), rest.get(), 4, MPFR_RNDN);
    // The first two have 33 bits: products with numbers of steps (19 bits) are exact.
    for (std::size_t i = 0; i < step.size(); ++i) {
      MpfrNumber part(mpfr_prec_t{i < 2 ? 33 : 53});
      mpfr_set(part.get(), rest.get(), MPFR_RNDN);
      step[i] = mpfr_get_d(part.get(), MPFR_RNDN);
      mpfr_sub(rest.get(), rest.get(), part.get(), MPFR_RNDN);
    }
    std::array<DoubleDouble, kAngleSteps / 4 + 1> first;
    for (std::size_t k = 0; k < first.size(); ++k) first[k] = sine_of_steps(k);
    for (std::size_t k = 0; k < kAngleSteps; ++k) {
      const std::size_t half = k % (kAngleSteps / 2);
      const DoubleDouble value = first[half <= kAngleSteps / 4 ? half : kAngleSteps / 2 - half];
      sine[k] = k < kAngleSteps / 2 ? value : -value;
    }
  }

  static DoubleDouble sine_of_steps(std::size_t k) {
    if (k == 0) return {0, 0};
    if (k == kAngleSteps / 4) return {1, 0};
    MpfrNumber value(mpfr_prec_t{400});
    mpfr_const_pi(value.get(), MPFR_RNDN);
    mpfr_mul_ui(value.get(), value.get(), static_cast<unsigned long>(k), MPFR_RNDN);
    mpfr_div_2ui(value.get(), value.get(), 4, MPFR_RNDN);
    mpfr_sin(value.get(), value.get(), MPFR_RNDN);
    DoubleDouble result;
    result.hi = mpfr_get_d(value.get(), MPFR_RNDN);
    mpfr_sub_d(value.get(), value.get(), result.hi, MPFR_RNDN);
    result.lo = mpfr_get_d(value.get(), MPFR_RNDN);
    return result;
  }

  std::array<double, 3> step{};                  ///< parts of pi/16
  std::array<DoubleDouble, kAngleSteps> sine{};  ///< of k pi/16
};

/// sin(r) for |r| < 0.0983, r2 = r^2: relative error below 2^-95.
DoubleDouble sine_of_small(const DoubleDouble& r, const DoubleDouble& r2) {
  const double p = r2.hi;
  const double tail =
      kCoefficient<9>.hi +
      p * (-kCoefficient<11>.hi +
           p * (kCoefficient<13>.hi + p * (-kCoefficient<15>.hi + p * kCoefficient<17>.hi)));
  const DoubleDouble inner = -kCoefficient<7> + DoubleDouble{p * tail, 0};
  const DoubleDouble middle = kCoefficient<5> + r2 * inner;
  return r + r * (r2 * (r2 * middle - kCoefficient<3>));
}

/// cos(r) for the same: error below 2^-93.
DoubleDouble cosine_of_small(const DoubleDouble& r2) {
  const double p = r2.hi;
  const double tail =
      kCoefficient<8>.hi +
      p * (-kCoefficient<10>.hi +
           p * (kCoefficient<12>.hi + p * (-kCoefficient<14>.hi + p * kCoefficient<16>.hi)));
  const DoubleDouble inner = -kCoefficient<6> + DoubleDouble{p * tail, 0};
  const DoubleDouble middle = kCoefficient<4> + r2 * inner;
  return DoubleDouble{1, 0} + r2 * (r2 * middle - kCoefficient<2>);
}

/// An angle as steps of pi/16, by their sine and cosine, and the rest, |rest| < 0.0983.
struct ReducedAngle {
  bool is_rest = false;  ///< there are no steps: the rest is the angle, exactly
  DoubleDouble rest, sine, cosine;
};

ReducedAngle reduced(double x) {
  static const AngleTables tables;
  const int k = static_cast<int>(x * kStepsPerRadian + (x < 0 ? -0.5 : 0.5));
  DoubleDouble r{x, 0};
  if (k != 0) {
    r = exact_sum(x, -(k * tables.step[0])) + DoubleDouble{-(k * tables.step[1]), 0};
    r = r + -exact_product(k, tables.step[2]);
  }
  const auto step = static_cast<std::size_t>(k & (kAngleSteps - 1));
  return {k == 0, r, tables.sine[step], tables.sine[(step + kAngleSteps / 4) % kAngleSteps]};
}

}  // namespace

// With r the rest of the angle, |r| < 0.0983, and A, B the sine and cosine of the steps,
// sin x = A + A c + B s with s = sin r and c = cos r - 1. The terms r and r^2/2 are taken without
// rounding. What is added to s in doubles is below 2^-12.6, with a relative error below 2^-51; what
// is added to c is below 2^-18; and the sums of it round nine times.
SineCosine sine_cosine_of_few_digits(double x) {
  const auto& [is_rest, r, at_sine, at_cosine] = reduced(x);
  const DoubleDouble square = exact_product(r.hi, r.hi);
  const double q = square.hi;
  const double s =
      r.lo * (1 - q / 2) +
      r.hi * q *
          (-kCoefficient<3>.hi +
           q * (kCoefficient<5>.hi +
                q * (-kCoefficient<7>.hi + q * (kCoefficient<9>.hi - q * kCoefficient<11>.hi))));
  const double c =
      -square.lo / 2 - r.hi * r.lo +
      q * q *
          (kCoefficient<4>.hi +
           q * (-kCoefficient<6>.hi + q * (kCoefficient<8>.hi - q * kCoefficient<10>.hi)));
  const auto combined = [&, &r = r](const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble of_r = exact_product(b.hi, r.hi), of_q = exact_product(a.hi, -q / 2);
    const DoubleDouble first = exact_sum(a.hi, of_r.hi), second = exact_sum(first.hi, of_q.hi);
    const double rest = a.lo + b.lo * r.hi + a.lo * (-q / 2) + of_r.lo + of_q.lo + first.lo +
                        second.lo + a.hi * c + b.hi * s;
    return exact_sum(second.hi, rest);
  };
  return {combined(at_sine, at_cosine), combined(at_cosine, -at_sine),
          is_rest ? 0x1p-58 * std::abs(x) : 0x1p-60, 0x1p-60};
}

SineCosine sine_cosine(double x) {
  const auto& [is_rest, r, at_sine, at_cosine] = reduced(x);
  const DoubleDouble r2 = r * r;
  const DoubleDouble sine = sine_of_small(r, r2), cosine = cosine_of_small(r2);
  if (is_rest) return {sine, cosine, kRelativeError * std::abs(x), kRelativeError};
  return {at_sine * cosine + at_cosine * sine, at_cosine * cosine - at_sine * sine, kRelativeError,
          kRelativeError};
}

double sin(double x) {
  const auto otherwise = [x] {
    return nearest_of([&](mpfr_ptr y) { return mpfr_sin(y, MpfrNumber(x).get(), MPFR_RNDZ); });
  };
  if (x == 0) return x;
  if (!(std::abs(x) <= kLargestAngle)) return otherwise();
  const SineCosine at = sine_cosine_of_few_digits(x);
  return nearest_within(at.sin, at.sin_error, [&] {
    const SineCosine more = sine_cosine(x);
    return nearest_within(more.sin, more.sin_error, otherwise);
  });
}

double cos(double x) {
  const auto otherwise = [x] {
    return nearest_of([&](mpfr_ptr y) { return mpfr_cos(y, MpfrNumber(x).get(), MPFR_RNDZ); });
  };
  if (!(std::abs(x) <= kLargestAngle)) return otherwise();
  const SineCosine at = sine_cosine_of_few_digits(x);
  return nearest_within(at.cos, at.cos_error, [&] {
    const SineCosine more = sine_cosine(x);
    return nearest_within(more.cos, more.cos_error, otherwise);
  });
}

double tan(double x) {
  const auto otherwise = [x] {
    return nearest_of([&](mpfr_ptr y) { return mpfr_tan(y, MpfrNumber(x).get(), MPFR_RNDZ); });
  };
  if (x == 0) return x;
  if (!(std::abs(x) <= kLargestAngle)) return otherwise();
  const SineCosine at = sine_cosine(x);
  const double quotient = at.sin.hi / at.cos.hi;
  const DoubleDouble rest = at.sin - quotient * at.cos;
  const double error =
      4 * std::abs(quotient) *
      (kRelativeError + at.sin_error / std::abs(at.sin.hi) + at.cos_error / std::abs(at.cos.hi));
  return nearest_within(ordered_sum(quotient, rest.hi / at.cos.hi), error, otherwise);
}

}  // namespace tensortopo::elementary
