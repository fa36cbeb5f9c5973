// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The checker's two arithmetics, and what they prove of a simplex.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "files/hexadecimal.hpp"
#include "level.hpp"
#include "mesh/exact_signs.hpp"
#include "topology.hpp"

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

/// Of all doubles as C writes them, and of numbers between two doubles.
RC_GTEST_PROP(CheckerArithmetic, HexadecimalTextsAreReadExactly, ()) {
  const int exponent = *rc::gen::inRange(-1074, 960);
  const double x = std::ldexp(static_cast<double>(*rc::gen::inRange(0, 1 << 30)), exponent);
  char text[64];
  std::snprintf(text, sizeof text, "%a", x);
  const auto read = hexadecimal(text);
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == mpq_class(x));
  const std::string digits = *rc::gen::element("0x1.80000000000001", "0x3.00000000000002");
  const auto other = hexadecimal(digits + "p" + std::to_string(exponent));
  RC_ASSERT(other.has_value());
  RC_ASSERT(*other != mpq_class(other->get_d()));
  for (const char* wrong : {"", "0x", "0xp1", "1", "0x1p", "0x1p+-1", "0x1.8.0", "0x1g", "-0x1",
                            "0x1 ", "0x1p99999999999999999999", "0x1p1.5", "0X1"})
    RC_ASSERT(!hexadecimal(wrong));
}

/// In planes, next to planes, of numbers of all sizes down to the least: as rational numbers say.
TEST(CheckerArithmetic, SidesAreExact) {
  using P = std::array<double, 3>;
  std::mt19937_64 random(7);
  std::array<int, 3> signs{};
  for (int n = 0; n < 20000; ++n) {
    const int scale = std::array{0, 0, 0, 300, -300, -1060}[random() % 6];
    const auto whole = [&] { return static_cast<double>(static_cast<int>(random() % 9) - 4); };
    P a{}, b{}, c{}, d{};
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = whole(), b[k] = whole(), c[k] = whole();
      d[k] = a[k] + (b[k] - a[k]) * 3 - (c[k] - a[k]) * 2;  // in the plane
    }
    if (random() % 2 != 0)
      d[random() % 3] += whole() * std::ldexp(1.0, -static_cast<int>(random() % 45));
    for (P* p : {&a, &b, &c, &d})
      for (double& x : *p) x = std::ldexp(x, scale);
    const auto from_a = [&](const P& p, std::size_t k) {
      return mpq_class(mpq_class(p[k]) - mpq_class(a[k]));
    };
    mpq_class exact;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      exact += from_a(b, k) * (from_a(c, u) * from_a(d, v) - from_a(c, v) * from_a(d, u));
      ASSERT_EQ(turn(a, b, c, k),
                sgn(mpq_class(from_a(b, u) * from_a(c, v) - from_a(b, v) * from_a(c, u))));
    }
    ASSERT_EQ(side_of(a, b, c, d), sgn(exact)) << scale;
    ++signs[static_cast<std::size_t>(sgn(exact) + 1)];
  }
  for (const int count : signs) EXPECT_GT(count, 1000);
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

/// Is a tensor above the level?
bool is_above(const Level& level, const Tensor<mpz_class>& m) {
  Given given;
  given.tensors = {m};
  const Tensor<Ball> ball = as_balls(m);
  return level.above({&ball, 8, &given, 0});
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
  EXPECT_FALSE(is_above(level, diagonal(11, 2)));  // on the level counts as below
  EXPECT_TRUE(is_above(just_below, diagonal(11, 2)));
  EXPECT_FALSE(is_above(neutral, diagonal(1, 0)));
  EXPECT_TRUE(is_above(neutral, diagonal(2, -1)));
  EXPECT_FALSE(is_above(neutral, diagonal(0, 0)));
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
  // The mode stops to increase where it is 1, beyond the level.
  EXPECT_EQ(prove_edge(half, diagonal(1, 0), diagonal(2, -1)), Proof::monotone);
  // It is 1 in the middle of the edge, and passes the level before and after.
  EXPECT_EQ(prove_edge(Level(9, 10), diagonal(1, 0), diagonal(3, -2)), Proof::open);
  // Through zero, where there is no mode.
  EXPECT_EQ(prove_edge(half, diagonal(2, -1), diagonal(-2, 1)), Proof::open);
  // Constant at the level, or not at it.
  const Level at(-143, 343);
  EXPECT_EQ(prove_edge(at, diagonal(11, 2), diagonal(22, 4)), Proof::empty);
  EXPECT_EQ(prove_edge(half, diagonal(11, 2), diagonal(22, 4)), Proof::empty);
}

/// Corners with what they need to stay alive.
template <std::size_t V>
struct Simplex {
  Given given;
  std::array<Tensor<Ball>, V> balls;
  std::array<Corner, V> corners;

  Simplex(const Level& level, const std::array<Tensor<mpz_class>, V>& tensors) {
    given.tensors.assign(tensors.begin(), tensors.end());
    for (std::uint32_t i = 0; i < V; ++i) {
      balls[i] = as_balls(tensors[i]);
      corners[i] = {&balls[i], 8, &given, i};
      corners[i].above = level.above(corners[i]);
    }
  }
};

/// diag(1000, k, -1000 - k) has a mode of about -0.0026 k: between the corners lie 0 and, the other
/// side of it, a mode as far from 0 as the level's.
TEST(CheckerArithmetic, ALevelNearZeroIsTakenApartFromItsOpposite) {
  for (const int sign : {1, -1}) {
    const Level level(sign, 50);
    const Simplex<2> clear(level, {diagonal(1000, -4 * sign), diagonal(1000, 160 * sign)});
    EXPECT_EQ(clear.corners[0].above, sign < 0);
    EXPECT_TRUE(level.is_one_sided(clear.corners)) << sign;
    const Simplex<2> crossed(level, {diagonal(1000, -12 * sign), diagonal(1000, 160 * sign)});
    EXPECT_NE(crossed.corners[0].above, crossed.corners[1].above);
    EXPECT_FALSE(level.is_one_sided(crossed.corners)) << sign;
  }
}

/// What is shown to be on one side is there, wherever one looks; and much is shown.
TEST(CheckerArithmetic, OneSidedTrianglesAreOneSided) {
  std::mt19937_64 random(20241201);
  const auto number = [&](int most) {
    return static_cast<int>(random() % (2 * static_cast<unsigned>(most) + 1)) - most;
  };
  int shown = 0, left = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Level level(number(trial % 2 == 0 ? 5 : 99), 100);
    const Tensor<mpz_class> middle{1000, number(300), 0, number(100), number(100), number(100)};
    std::array<Tensor<mpz_class>, 3> tensors;
    for (auto& t : tensors) {
      t = middle;
      for (auto& x : t) x += number(std::array{20, 100, 400}[static_cast<std::size_t>(trial) % 3]);
      t[2] = -t[0] - t[1];
    }
    const Simplex<3> s(level, tensors);
    if (s.corners[0].above != s.corners[1].above || s.corners[0].above != s.corners[2].above)
      continue;
    if (!level.is_one_sided(s.corners)) {
      ++left;
      continue;
    }
    ++shown;
    for (int i = 0; i <= 6; ++i) {
      for (int j = 0; i + j <= 6; ++j) {
        Tensor<mpz_class> m;
        for (std::size_t k = 0; k < 6; ++k)
          m[k] = i * tensors[0][k] + j * tensors[1][k] + (6 - i - j) * tensors[2][k];
        ASSERT_EQ(is_above(level, m), s.corners[0].above) << "trial " << trial;
      }
    }
  }
  EXPECT_GT(shown, 10 * left);
}

/// Along the direction of a proof points above the level stay above it; and much is proved.
template <std::size_t V>
void monotone_simplices_are_crossed_upwards(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto number = [&](int most) {
    return static_cast<int>(random() % (2 * static_cast<unsigned>(most) + 1)) - most;
  };
  int proved = 0, crossed = 0;
  long moved = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const int kind = trial % 5;
    const Level level(kind == 0 ? 0 : kind == 1 ? 999 - 1998 * (trial % 2) : number(900), 1000);
    // Next to modes 1 and -1 the middle has such a mode.
    Tensor<mpz_class> middle;
    middle[0] = 2000;
    middle[1] = kind == 1 ? -1000 : number(1200);
    for (std::size_t k = 3; k < 6; ++k) middle[k] = kind == 1 ? 0 : number(400);
    const int sign = kind == 1 && trial % 2 == 1 ? -1 : 1;
    const int spread = std::array{60, 300, 900}[static_cast<std::size_t>(trial) % 3];
    std::array<Tensor<mpz_class>, V> tensors;
    for (auto& t : tensors) {
      t = middle;
      for (mpz_class& x : t) {
        x += number(spread);
        x *= sign;
      }
      t[2] = -t[0] - t[1];
    }
    const Simplex<V> s(level, tensors);
    const auto proof = level.prove(s.corners);
    if (proof.proof != Proof::monotone) continue;
    ++proved;
    for (std::size_t i = 1; i < V; ++i)
      if (s.corners[i].above != s.corners[0].above) {
        ++crossed;
        break;
      }
    for (int line = 0; line < 12; ++line) {
      std::array<long, V> weights;
      for (long& w : weights) w = 40000L * static_cast<long>(random() % 6);
      bool was_above = false;
      for (long step = 0; step < 40; ++step) {
        Tensor<mpz_class> m;
        bool is_inside = true, any = false;
        for (std::size_t i = 0; i < V; ++i) {
          const long w = weights[i] + step * proof.direction[i] / 8;
          is_inside = is_inside && w >= 0;
          any = any || w > 0;
          for (std::size_t k = 0; k < 6; ++k) {
            mpz_class share = tensors[i][k];
            share *= w;
            m[k] += share;
          }
        }
        if (!is_inside || !any) break;
        const bool above = is_above(level, m);
        ASSERT_TRUE(above || !was_above) << "trial " << trial << ", line " << line;
        was_above = above;
        moved += step > 0;
      }
    }
  }
  EXPECT_GT(proved, 400);
  EXPECT_GT(crossed, 100);
  EXPECT_GT(moved, 10000);
}

TEST(CheckerArithmetic, MonotoneEdgesAreCrossedUpwards) {
  monotone_simplices_are_crossed_upwards<2>(1);
}
TEST(CheckerArithmetic, MonotoneTrianglesAreCrossedUpwards) {
  monotone_simplices_are_crossed_upwards<3>(2);
}
TEST(CheckerArithmetic, MonotoneTetrahedraAreCrossedUpwards) {
  monotone_simplices_are_crossed_upwards<4>(3);
}

/// A tetrahedron with an annulus. Cut faces of it have monotone triangles with an edge that no
/// proof covers as a whole, which more cuts of the face only make narrower.
TEST(CheckerTopology, EdgesOfMonotoneTrianglesAreCutByThemselves) {
  Input input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  input.tets = {{0, 1, 2, 3}};
  input.tensors = {
      {-1, 0, -3, 1, 4, -5}, {5, -1, 2, 5, -5, -3}, {-5, -1, -5, -1, 1, 1}, {3, -2, 5, -5, 1, 5}};
  const Level level(101, 500);
  const ForAll each = [](std::size_t count, const std::function<void(std::size_t)>& f,
                         const char*) {
    for (std::size_t i = 0; i < count; ++i) f(i);
  };
  const Field field(input, level.multiples(), each);
  const Topology topology = derive_topology(input, field, level, {false}, each, each);
  ASSERT_EQ(topology.tets.size(), 1u);
  ASSERT_TRUE(topology.tets[0].decided);
  ASSERT_EQ(topology.tets[0].sheets.size(), 1u);
  EXPECT_EQ(topology.tets[0].sheets[0].euler_characteristic, 0);
  EXPECT_EQ(topology.tets[0].sheets[0].loops.size(), 2u);
}

}  // namespace
}  // namespace certificate
