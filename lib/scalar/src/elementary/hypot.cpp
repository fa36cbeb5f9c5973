// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tensortopo/scalar/elementary.hpp"
#include "to_nearest.hpp"

namespace tensortopo::elementary {

namespace {

/// Squares of doubles added without rounding: exponents from -2148 to 2050.
constexpr mpfr_prec_t kExactSum = 4300;

double hypot_of_exact_sum(double x, double y, double z) {
  MpfrNumber sum(kExactSum), square(mpfr_prec_t{106});
  mpfr_sqr(sum.get(), MpfrNumber(x).get(), MPFR_RNDN);
  for (const double c : {y, z}) {
    mpfr_sqr(square.get(), MpfrNumber(c).get(), MPFR_RNDN);
    mpfr_add(sum.get(), sum.get(), square.get(), MPFR_RNDN);
  }
  return nearest_of([&](mpfr_ptr root) { return mpfr_sqrt(root, sum.get(), MPFR_RNDZ); });
}

/// The root of a sum of squares of size 2^-800 to 2^802.
template <class Otherwise>
double root_of_squares(const DoubleDouble& sum, const Otherwise& otherwise) {
  const double start = std::sqrt(sum.hi);
  const DoubleDouble rest = sum - exact_product(start, start);
  return nearest_within(ordered_sum(start, rest.hi / (2 * start)), kRelativeError * start,
                        otherwise);
}

bool is_moderate(double size) { return size > 0x1p-400 && size < 0x1p400; }

}  // namespace

double hypot(double x, double y) {
  if (std::isinf(x) || std::isinf(y)) return HUGE_VAL;
  const auto otherwise = [&] { return hypot_of_exact_sum(x, y, 0); };
  if (!is_moderate(std::max(std::abs(x), std::abs(y)))) return otherwise();
  return root_of_squares(exact_product(x, x) + exact_product(y, y), otherwise);
}

double hypot(double x, double y, double z) {
  if (std::isinf(x) || std::isinf(y) || std::isinf(z)) return HUGE_VAL;
  const auto otherwise = [&] { return hypot_of_exact_sum(x, y, z); };
  if (!is_moderate(std::max({std::abs(x), std::abs(y), std::abs(z)}))) return otherwise();
  return root_of_squares((exact_product(x, x) + exact_product(y, y)) + exact_product(z, z),
                         otherwise);
}

}  // namespace tensortopo::elementary
