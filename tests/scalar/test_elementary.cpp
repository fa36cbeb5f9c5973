// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/scalar/elementary.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace {

namespace elementary = tensortopo::elementary;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A value of MPFR at 53 bits, with double's exponents and subnormal numbers.
template <class Compute>
double reference(const Compute& compute) {
  mpfr_t x, y, r;
  mpfr_inits2(53, x, y, r, static_cast<mpfr_ptr>(nullptr));
  const mpfr_exp_t emin = mpfr_get_emin(), emax = mpfr_get_emax();
  mpfr_set_emin(-1073), mpfr_set_emax(1024);
  int ternary = compute(r, x, y);
  ternary = mpfr_check_range(r, ternary, MPFR_RNDN);
  mpfr_subnormalize(r, ternary, MPFR_RNDN);
  const double result = mpfr_get_d(r, MPFR_RNDN);
  mpfr_set_emin(emin), mpfr_set_emax(emax);
  mpfr_clears(x, y, r, static_cast<mpfr_ptr>(nullptr));
  return result;
}

using OneArgument = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using TwoArguments = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

double reference(OneArgument f, double a) {
  return reference([&](mpfr_ptr r, mpfr_ptr x, mpfr_ptr) {
    mpfr_set_d(x, a, MPFR_RNDN);
    return f(r, x, MPFR_RNDN);
  });
}
double reference(TwoArguments f, double a, double b) {
  return reference([&](mpfr_ptr r, mpfr_ptr x, mpfr_ptr y) {
    mpfr_set_d(x, a, MPFR_RNDN);
    mpfr_set_d(y, b, MPFR_RNDN);
    return f(r, x, y, MPFR_RNDN);
  });
}

testing::AssertionResult same_bits(double got, double expected, double a, double b) {
  if ((std::isnan(got) && std::isnan(expected)) ||
      std::bit_cast<std::uint64_t>(got) == std::bit_cast<std::uint64_t>(expected))
    return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << std::hexfloat << "of " << a << ", " << b << ": " << got << ", not " << expected;
}

/// Numbers of all sizes, many of moderate ones, and the neighbours of special ones.
std::vector<double> arguments(int count) {
  std::vector<double> result{0.0,          -0.0,   kInfinity, -kInfinity,
                             std::nan(""), 5e-324, 1e308,     -1e-308};
  for (const double centre : {1.0, 0.5, std::numbers::pi, 2.0, std::numbers::sqrt2 / 2, 1e-8,
                              709.78, 745.1, 600.0, 65536.0, 0x1p-27, 0.0981747704246810387})
    for (const double sign : {1.0, -1.0})
      for (int k = 0; k <= 8; ++k) {
        double x = sign * centre * (k == 0 ? 1 : k / 4.0), below = x, above = x;
        result.push_back(x);
        for (int i = 0; i < 3; ++i) {
          result.push_back(below = std::nextafter(below, -kInfinity));
          result.push_back(above = std::nextafter(above, kInfinity));
        }
      }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1), exponent(-60, 12);
  for (int i = 0; i < count; ++i) {
    result.push_back(unit(random));
    result.push_back(4 * unit(random));
    result.push_back(unit(random) * std::exp2(std::floor(exponent(random))));
    result.push_back(1 - std::abs(unit(random)) * std::exp2(std::floor(exponent(random)) - 8));
    result.push_back(std::bit_cast<double>(random()));
  }
  return result;
}

struct Function {
  const char* name;
  double (*ours)(double);
  OneArgument mpfr;
};

class Elementary : public testing::TestWithParam<Function> {};

TEST_P(Elementary, IsRoundedCorrectly) {
  std::size_t compared = 0;
  for (const double x : arguments(2000)) {
    ASSERT_TRUE(same_bits(GetParam().ours(x), reference(GetParam().mpfr, x), x, 0));
    ++compared;
  }
  EXPECT_GT(compared, 10000);
}

INSTANTIATE_TEST_SUITE_P(Functions, Elementary,
                         testing::Values(Function{"sin", elementary::sin, mpfr_sin},
                                         Function{"cos", elementary::cos, mpfr_cos},
                                         Function{"tan", elementary::tan, mpfr_tan},
                                         Function{"asin", elementary::asin, mpfr_asin},
                                         Function{"acos", elementary::acos, mpfr_acos},
                                         Function{"atan", elementary::atan, mpfr_atan},
                                         Function{"exp", elementary::exp, mpfr_exp},
                                         Function{"log", elementary::log, mpfr_log},
                                         Function{"cbrt", elementary::cbrt, mpfr_cbrt}),
                         [](const auto& tested) { return tested.param.name; });

TEST(ElementaryOfTwo, IsRoundedCorrectly) {
  const std::vector<double> x = arguments(1000);
  std::mt19937_64 random(2);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    // With one of any size, of the same size, the same, and special ones.
    const double partners[] = {x[random() % x.size()],
                               x[i] * (1 + 0x1p-52 * static_cast<double>(random() % 64)),
                               x[random() % 100], 1, -0.0};
    for (const double y : partners) {
      ASSERT_TRUE(same_bits(elementary::atan2(y, x[i]), reference(mpfr_atan2, y, x[i]), y, x[i]));
      ASSERT_TRUE(same_bits(elementary::hypot(y, x[i]), reference(mpfr_hypot, y, x[i]), y, x[i]));
      compared += 2;
    }
  }
  EXPECT_GT(compared, 30000);
}

TEST(ElementaryOfThree, IsRoundedCorrectly) {
  std::mt19937_64 random(3);
  const std::vector<double> x = arguments(300);
  std::size_t compared = 0;
  for (std::size_t i = 2; i < x.size(); ++i) {
    const double a = x[i], b = x[random() % x.size()], c = x[i - 2];
    const double expected = reference([&](mpfr_ptr r, mpfr_ptr, mpfr_ptr) {
      // The sum of squares without rounding, and one root.
      mpfr_set_emin(-5000), mpfr_set_emax(5000);
      mpfr_t sum, square;
      mpfr_init2(sum, 4400), mpfr_init2(square, 106);
      mpfr_set_zero(sum, 1);
      for (const double v : {a, b, c}) {
        mpfr_set_d(square, v, MPFR_RNDN);
        mpfr_sqr(square, square, MPFR_RNDN);
        mpfr_add(sum, sum, square, MPFR_RNDN);
      }
      const int ternary = mpfr_sqrt(r, sum, MPFR_RNDN);
      mpfr_clear(sum), mpfr_clear(square);
      mpfr_set_emin(-1073), mpfr_set_emax(1024);
      return ternary;
    });
    if (std::isinf(a) || std::isinf(b) || std::isinf(c)) continue;
    ASSERT_TRUE(same_bits(elementary::hypot(a, b, c), expected, a, b)) << c;
    ++compared;
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
