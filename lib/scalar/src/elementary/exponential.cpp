// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstddef>

#include "tensortopo/scalar/elementary.hpp"
#include "to_nearest.hpp"

namespace tensortopo::elementary {

namespace {

/// Steps of log(2) / 32.
constexpr int kPowerSteps = 32;
constexpr double kStepsPerUnit = 46.166241308446828;

struct PowerTables {
  PowerTables() {
    MpfrNumber rest(mpfr_prec_t{400});
    mpfr_const_log2(rest.get(), MPFR_RNDN);
    mpfr_div_2ui(rest.get(), rest.get(), 5, MPFR_RNDN);
    // The first two have 36 bits: products with numbers of steps (16 bits) are exact.
    for (std::size_t i = 0; i < step.size(); ++i) {
      MpfrNumber part(mpfr_prec_t{i < 2 ? 36 : 53});
      mpfr_set(part.get(), rest.get(), MPFR_RNDN);
      step[i] = mpfr_get_d(part.get(), MPFR_RNDN);
      mpfr_sub(rest.get(), rest.get(), part.get(), MPFR_RNDN);
    }
    for (std::size_t k = 0; k < power.size(); ++k) {
      MpfrNumber value(mpfr_prec_t{400});
      mpfr_set_ui_2exp(value.get(), k, -5, MPFR_RNDN);
      mpfr_exp2(value.get(), value.get(), MPFR_RNDN);
      power[k].hi = mpfr_get_d(value.get(), MPFR_RNDN);
      mpfr_sub_d(value.get(), value.get(), power[k].hi, MPFR_RNDN);
      power[k].lo = mpfr_get_d(value.get(), MPFR_RNDN);
    }
  }
  std::array<double, 3> step{};                   ///< parts of log(2) / 32
  std::array<DoubleDouble, kPowerSteps> power{};  ///< 2^(k/32)
};

/// exp(x) with a relative error below 2^-90.
/// @pre |x| <= 700
DoubleDouble exponential(double x) {
  static const PowerTables tables;
  const int k = static_cast<int>(x * kStepsPerUnit + (x < 0 ? -0.5 : 0.5));
  DoubleDouble r = exact_sum(x, -(k * tables.step[0]));
  r = r + DoubleDouble{-(k * tables.step[1]), 0};
  r = r + -exact_product(k, tables.step[2]);
  const double p = r.hi;
  const double tail = kCoefficient<5>.hi +
                      p * (kCoefficient<6>.hi +
                           p * (kCoefficient<7>.hi +
                                p * (kCoefficient<8>.hi +
                                     p * (kCoefficient<9>.hi +
                                          p * (kCoefficient<10>.hi + p * kCoefficient<11>.hi)))));
  const DoubleDouble inner = kCoefficient<4> + DoubleDouble{p * tail, 0};
  const DoubleDouble series = r + r * (r * (kCoefficient<2> + r * (kCoefficient<3> + r * inner)));
  const int part = k & (kPowerSteps - 1), whole = (k - part) / kPowerSteps;
  const DoubleDouble& power = tables.power[static_cast<std::size_t>(part)];
  const DoubleDouble result = power + power * series;
  return {std::ldexp(result.hi, whole), std::ldexp(result.lo, whole)};
}

}  // namespace

double exp(double x) {
  const auto otherwise = [x] {
    return nearest_of([&](mpfr_ptr y) { return mpfr_exp(y, MpfrNumber(x).get(), MPFR_RNDZ); });
  };
  if (!(std::abs(x) <= 600)) return otherwise();
  const DoubleDouble value = exponential(x);
  return nearest_within(value, kRelativeError * value.hi, otherwise);
}

double log(double x) {
  const auto otherwise = [x] {
    return nearest_of([&](mpfr_ptr y) { return mpfr_log(y, MpfrNumber(x).get(), MPFR_RNDZ); });
  };
  if (!(x > 0x1p-800 && x < 0x1p800)) return otherwise();
  // One step from what the C library gives: x e^-start = 1 + rest.
  const double start = std::log(x);
  const DoubleDouble rest = x * exponential(-start) - DoubleDouble{1, 0};
  if (!(std::abs(rest.hi) < 0x1p-40)) return otherwise();
  const DoubleDouble value = exact_sum(start, rest.hi - rest.hi * rest.hi / 2);
  return nearest_within(value, kRelativeError + std::abs(rest.hi * rest.hi * rest.hi), otherwise);
}

double cbrt(double x) {
  const auto otherwise = [x] {
    return nearest_of([&](mpfr_ptr y) { return mpfr_cbrt(y, MpfrNumber(x).get(), MPFR_RNDZ); });
  };
  if (!(std::abs(x) > 0x1p-300 && std::abs(x) < 0x1p300)) return otherwise();
  const double start = std::cbrt(x);
  const DoubleDouble square = exact_product(start, start);
  const double step = (DoubleDouble{x, 0} - start * square).hi / (3 * square.hi);
  if (!(std::abs(step) < 0x1p-40 * std::abs(start))) return otherwise();
  return nearest_within(ordered_sum(start, step),
                        kRelativeError * std::abs(start) + 4 * step * step / std::abs(start),
                        otherwise);
}

}  // namespace tensortopo::elementary
