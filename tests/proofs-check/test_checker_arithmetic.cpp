// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The checker's two arithmetics, and what they prove of a simplex.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "level.hpp"

namespace certificate {
namespace {

bool contains(const Ball& ball, const mpq_class& x) {
  return abs(x - mpq_class(ball.value)) <= mpq_class(ball.error);
}

double any_double(int mantissa, int exponent) { return std::ldexp(mantissa, exponent); }

/// Sums and products, of near-zero, cancelling and tiny terms, contain the exact value.
RC_GTEST_PROP(CheckerArithmetic, BallsContainTheTruth, ()) {
  const auto number = rc::gen::apply(any_double, rc::gen::arbitrary<int>(),
                                     rc::gen::element(0, 0, -1, -31, -400, -700, 60));
  const double start = *number;
  Ball ball(start, 0);
  mpq_class exact(start);
  for (const double x : *rc::gen::container<std::vector<double>>(6, number)) {
    const auto which = *rc::gen::inRange(0, 4);
    const Ball other(x, 0);
    if (which == 0) ball = ball + other, exact += mpq_class(x);
    if (which == 1) ball = ball * other, exact *= mpq_class(x);
    if (which == 2) ball = ball - other, exact -= mpq_class(x);
    if (which == 3) ball = ball * ball - other, exact = exact * exact - mpq_class(x);
    if (!std::isfinite(ball.value) || !std::isfinite(ball.error)) return;
    RC_ASSERT(contains(ball, exact));
  }
}

/// With full mantissas of all sizes, so that each operation rounds.
TEST(CheckerArithmetic, BallsContainRoundedForms) {
  std::mt19937_64 random(1);
  const auto number = [&] {
    const auto mantissa = static_cast<double>(static_cast<std::int64_t>(random())) / 3;
    return std::ldexp(mantissa, -static_cast<int>(random() % 90));
  };
  for (int n = 0; n < 20000; ++n) {
    const double x = number(), y = number(), z = number();
    const Ball ball = Ball(x, 0) * Ball(y, 0) - Ball(z, 0) * Ball(x, 0) + Ball(y, 0);
    const mpq_class a(x), b(y), c(z);
    ASSERT_TRUE(contains(ball, a * b - c * a + b)) << x << ' ' << y << ' ' << z;
    ASSERT_LT(ball.error, 1e-14 * (std::abs(x * y) + std::abs(x * z) + std::abs(y)));
  }
}

struct Given : ExactTensors {
  std::vector<Tensor<mpz_class>> tensors;
  Tensor<mpz_class> exact(std::uint32_t id) const override { return tensors[id]; }
};

Tensor<mpz_class> diagonal(int a, int b) { return {a, b, -a - b, 0, 0, 0}; }

Tensor<Ball> as_balls(const Tensor<mpz_class>& m) {
  Tensor<Ball> balls;
  for (std::size_t k = 0; k < 6; ++k) balls[k] = ball_of(m[k], 8);
  return balls;
}

Proof prove_edge(const Level& level, const Tensor<mpz_class>& a, const Tensor<mpz_class>& b) {
  Given given;
  given.tensors = {a, b};
  const std::array<Tensor<Ball>, 2> balls{as_balls(a), as_balls(b)};
  std::array<Corner, 2> corners;
  for (std::uint32_t i = 0; i < 2; ++i) {
    corners[i] = {&balls[i], 8, &given, i};
    corners[i].above = level.above(corners[i]);
  }
  return level.prove<2>(corners).proof;
}

/// diag(1, 0, -1) has mode 0, diag(2, -1, -1) mode 1; diag(11, 2, -13) exactly -143/343.
TEST(CheckerArithmetic, SidesOfKnownModes) {
  const Level level(-143, 343), just_below(-143001, 343000), neutral(0, 1);
  const auto above = [](const Level& l, const Tensor<mpz_class>& m) {
    const Tensor<Ball> ball = as_balls(m);
    return l.above(ball, m);
  };
  EXPECT_FALSE(above(level, diagonal(11, 2)));  // on the level counts as below
  EXPECT_TRUE(above(just_below, diagonal(11, 2)));
  EXPECT_FALSE(above(neutral, diagonal(1, 0)));
  EXPECT_TRUE(above(neutral, diagonal(2, -1)));
  EXPECT_FALSE(above(neutral, diagonal(0, 0)));
  const Tensor<mpz_class> m = diagonal(11, 2);
  const Tensor<Ball> ball = as_balls(m);
  Given given;
  given.tensors = {m};
  EXPECT_TRUE(level.on_level({&ball, 8, &given, 0}));
  EXPECT_FALSE(just_below.on_level({&ball, 8, &given, 0}));
}

TEST(CheckerArithmetic, ProofsOfEdges) {
  const Level half(1, 2);
  EXPECT_EQ(prove_edge(half, diagonal(1, 0), diagonal(10, -1)), Proof::empty);
  EXPECT_EQ(prove_edge(half, diagonal(1, 0), diagonal(11, -5)), Proof::monotone);
  // The mode stops to increase where it is 1.
  EXPECT_EQ(prove_edge(half, diagonal(1, 0), diagonal(2, -1)), Proof::open);
  // Through zero, where there is no mode.
  EXPECT_EQ(prove_edge(half, diagonal(2, -1), diagonal(-2, 1)), Proof::open);
  // Constant at the level, or not at it.
  const Level at(-143, 343);
  EXPECT_EQ(prove_edge(at, diagonal(11, 2), diagonal(22, 4)), Proof::empty);
  EXPECT_EQ(prove_edge(half, diagonal(11, 2), diagonal(22, 4)), Proof::empty);
}

}  // namespace
}  // namespace certificate
