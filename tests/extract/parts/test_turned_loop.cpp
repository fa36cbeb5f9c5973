// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include "extract/patch/fill/turned_loop.hpp"
#include "extract/subdivision/degenerate_offset.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

constexpr double kPi = std::numbers::pi;
const EigenvectorFrame kFrame{{1, 0, 0}, {0, 1, 0}};

/// Vertices whose medium eigenvectors, with signs of their own, are turned once around.
std::vector<BoundaryVertex> loop_around(std::size_t count, std::int32_t first_id, bool clockwise,
                                        std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.1, 1);
  std::vector<double> steps(count);
  double total = 0;
  for (auto& s : steps) total += s = share(random);
  double angle = 2 * kPi * share(random);
  std::vector<BoundaryVertex> loop(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = clockwise ? -angle : angle, sign = share(random) < 0.5 ? 1 : -1;
    loop[i].id = first_id + static_cast<std::int32_t>(i);
    loop[i].medium = {sign * std::cos(turn / 2), sign * std::sin(turn / 2), 0};
    angle += 2 * kPi * steps[i] / total;
  }
  return loop;
}

double largest_step(const TurnedLoop& loop) {
  double largest = loop.angles.front() + 2 * kPi - loop.angles.back();
  for (std::size_t i = 1; i < loop.angles.size(); ++i)
    largest = std::max(largest, loop.angles[i] - loop.angles[i - 1]);
  return largest;
}

// Each edge of the loops is one triangle's, each other edge two triangles', once in each direction;
// and joined vertices are turned alike.
TEST(TurnedLoops, AreJoinedByAStripOfTrianglesAsFarAsTheyAreTurnedAlike) {
  std::mt19937 random(20261128);
  std::uniform_int_distribution<std::size_t> size(3, 20);
  std::size_t joined = 0;
  for (int trial = 0; trial < trials(300); ++trial) {
    const std::size_t n = size(random), m = size(random);
    const bool clockwise = trial % 2 == 0;
    const auto lower = turned_loop(loop_around(n, 0, clockwise, random), kFrame);
    const auto upper = turned_loop(loop_around(m, 100, clockwise, random), kFrame);
    if (std::min(n, m) > 12) {
      ASSERT_TRUE(lower && upper);
    }
    if (!lower || !upper) continue;  // steps of half a turn or more have no direction
    EXPECT_EQ(lower->is_clockwise, clockwise);
    std::vector<std::array<std::int32_t, 3>> triangles;
    join_loops(lower->loop, upper->loop, triangles);
    ASSERT_EQ(triangles.size(), n + m);
    std::map<std::array<std::int32_t, 2>, int> directed;
    for (const auto& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) ++directed[{t[i], t[(i + 1) % 3]}];
    const auto angle_of = [&](std::int32_t id) {
      return id < 100 ? lower->loop.angles[static_cast<std::size_t>(id)]
                      : upper->loop.angles[static_cast<std::size_t>(id - 100)];
    };
    const double most = largest_step(lower->loop) + largest_step(upper->loop);
    for (const auto& [edge, count] : directed) {
      EXPECT_EQ(count, 1);
      const auto [a, b] = edge;
      const bool is_inside = (a < 100) != (b < 100);
      EXPECT_EQ(directed.contains({b, a}), is_inside);
      if (!is_inside) continue;
      EXPECT_LE(std::abs(std::remainder(angle_of(a) - angle_of(b), 2 * kPi)), most + 1e-9);
      ++joined;
    }
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(n); ++i)
      EXPECT_TRUE(directed.contains({i, (i + 1) % static_cast<std::int32_t>(n)}));
  }
  EXPECT_GT(joined, 1000u);
}

TEST(TurnedLoops, AreNoneWhereEigenvectorsDoNotGoOnceAround) {
  std::mt19937 random(7);
  auto loop = loop_around(12, 0, false, random);
  ASSERT_TRUE(turned_loop(loop, kFrame));
  std::swap(loop[3], loop[7]);
  EXPECT_FALSE(turned_loop(loop, kFrame));
  for (auto& v : loop) v.medium = {1, 0, 0};
  EXPECT_FALSE(turned_loop(loop, kFrame));
}

/// A tensor next to a degenerate one, whose dominant eigenvector is turned by an angle.
Deviator<double> beside_curve(double angle, double offset, int sign) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Deviator<double> t = deviator(SymmetricTensor<double>{
      c * c + offset * s * s, s * s + offset * c * c, -offset, c * s * (1 - offset), 0, 0});
  return static_cast<double>(sign) * t;
}

// The sag of chords beside a curve that bends: a quarter for half the chord, and half for twice the
// distance from the curve.
TEST(SagOfChord, IsThatOfTheCurveOverTheDistanceFromIt) {
  std::size_t compared = 0;
  for (const int sign : {1, -1})
    for (const double offset : {1e-4, 1e-6, 1e-8})
      for (const double turn : {0.1, 0.01}) {
        const auto sag = [&](double by, double from) {
          const auto a = beside_curve(0.3, from, sign), b = beside_curve(0.3 + by, from, sign);
          return detail::sag_of_chord(a, b, sign);
        };
        const double whole = sag(turn, offset);
        EXPECT_NEAR(sag(turn / 2, offset) / whole, 0.25, 0.01) << offset << ' ' << turn;
        EXPECT_NEAR(sag(turn, 2 * offset) / whole, 0.5, 0.01) << offset << ' ' << turn;
        // A straight chord beside a straight curve: the same dominant eigenvector all along.
        const auto a = beside_curve(0.3, offset, sign), b = beside_curve(0.3, 0.5 * offset, sign);
        EXPECT_LT(detail::sag_of_chord(a, b, sign), 1e-3);
        ++compared;
      }
  EXPECT_EQ(compared, 12u);
}

}  // namespace
}  // namespace tensortopo::test
