// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "tensortopo/field/binary_cubic.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {
namespace {

using Zero = std::array<int, 2>;

/// Coefficients of the product of y_i x - x_i y over three zeros (x_i : y_i).
template <class Scalar>
std::array<Scalar, 4> cubic_with_zeros(const std::array<Zero, 3>& z) {
  std::array<Scalar, 4> f = {Scalar(1), Scalar(0), Scalar(0), Scalar(0)};
  for (std::size_t n = 0; n < 3; ++n) {
    std::array<Scalar, 4> g{};
    for (std::size_t i = 0; i <= n; ++i) {
      g[i] = g[i] + Scalar(z[n][1]) * f[i];
      g[i + 1] = g[i + 1] - Scalar(z[n][0]) * f[i];
    }
    f = g;
  }
  return f;
}

template <class Scalar>
class BinaryCubicTest : public testing::Test {};
using Reals = testing::Types<double, Real50, Real100>;
TYPED_TEST_SUITE(BinaryCubicTest, Reals);

TYPED_TEST(BinaryCubicTest, FindsThreeDistinctRationalZeros) {
  using Scalar = TypeParam;
  rc::detail::checkGTest([] {
    std::array<Zero, 3> z{};
    for (auto& p : z)
      for (int& x : p) x = *rc::gen::inRange(-9, 10);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& p = z[i];
      const auto& q = z[(i + 1) % 3];
      RC_PRE(p[0] * q[1] != p[1] * q[0]);
    }
    const auto zeros = binary_cubic_zeros(cubic_with_zeros<Scalar>(z));
    RC_ASSERT(zeros.size() == 3u);
    for (const auto& p : z) {
      Scalar nearest(1);
      for (const auto& [x, y] : zeros)
        nearest = std::min(nearest, Scalar(abs(Scalar(x * Scalar(p[1]) - y * Scalar(p[0])))));
      // Zeros are at least 1/162 apart, so the condition number stays below 162^2; ten roundings.
      RC_ASSERT(nearest <= Scalar(1 << 18) * std::numeric_limits<Scalar>::epsilon());
    }
  });
}

TYPED_TEST(BinaryCubicTest, FindsOneZeroOfASumOfSquaresTimesALine) {
  using Scalar = TypeParam;
  // (x^2 + y^2)(2 x - y): zero at (1 : 2).
  const auto zeros = binary_cubic_zeros<Scalar>({Scalar(2), Scalar(-1), Scalar(2), Scalar(-1)});
  ASSERT_EQ(zeros.size(), 1u);
  EXPECT_LE(abs(Scalar(Scalar(2) * zeros[0][0] - zeros[0][1])),
            Scalar(8) * std::numeric_limits<Scalar>::epsilon());
}

TYPED_TEST(BinaryCubicTest, FindsZerosAtBothEndsOfTheLine) {
  using Scalar = TypeParam;
  // x y (x - y).
  EXPECT_EQ((binary_cubic_zeros<Scalar>({Scalar(0), Scalar(1), Scalar(-1), Scalar(0)}).size()), 3u);
  // y^3 and x^3: a triple zero may come once or three times.
  for (const auto& f : {std::array<Scalar, 4>{Scalar(0), Scalar(0), Scalar(0), Scalar(1)},
                        std::array<Scalar, 4>{Scalar(1), Scalar(0), Scalar(0), Scalar(0)}})
    EXPECT_NE(binary_cubic_zeros<Scalar>(f).size() % 2, 0u);
}

TYPED_TEST(BinaryCubicTest, OfTheZeroFormIsEmpty) {
  EXPECT_TRUE(binary_cubic_zeros<TypeParam>({}).empty());
}

}  // namespace
}  // namespace tensortopo
