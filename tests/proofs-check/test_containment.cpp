// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/containment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace certificate {
namespace {

/// A point of a simplex as a program would compute it, by weights in doubles.
Point3 rounded_point(const std::vector<Point3>& corners, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> w(corners.size());
  double rest = 1;
  for (std::size_t i = 1; i < w.size(); ++i) {
    w[i] = uniform(random) * rest;
    rest -= w[i];
  }
  w[0] = rest;
  Point3 x{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < w.size(); ++i) x[k] += w[i] * corners[i][k];
  return x;
}

TEST(Containment, HoldsPointsAsTheyAreComputedAndNoneBeside) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::size_t compared = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const double scale = std::ldexp(1, trial % 40 - 20), offset = trial % 3 == 0 ? 0 : 10 * scale;
    std::vector<Point3> corners(2 + static_cast<std::size_t>(trial) % 3);
    for (Point3& p : corners)
      for (double& x : p) x = offset + scale * uniform(random);
    if (trial % 7 == 0) corners.back()[static_cast<std::size_t>(trial) % 3] = 0;  // a coordinate without rounding
    const Point3 x = rounded_point(corners, random);
    EXPECT_TRUE(lies_in(x, corners));
    ++compared;
    // Farther off in a direction in which all corners are on the other side.
    Point3 away = x;
    const std::size_t k = static_cast<std::size_t>(trial / 3) % 3;
    for (const Point3& p : corners) away[k] = std::max(away[k], p[k]);
    away[k] += std::max(std::abs(away[k]), scale) * 0x1p-45;
    EXPECT_FALSE(lies_in(away, corners));
  }
  EXPECT_EQ(compared, 4000u);
}

TEST(Containment, OfAnIntervalOfAnEdge) {
  const Point3 a{1, 2, 3}, b{3, -2, 5};
  for (int i = 0; i < 64; ++i) {
    const double t = (i + 0.5) / 64;
    const Point3 x{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
    EXPECT_TRUE(lies_between(x, a, b, mpq_class(i, 64), mpq_class(i + 1, 64)));
    EXPECT_FALSE(lies_between(x, a, b, mpq_class(i + 1, 64), 1));
    EXPECT_FALSE(lies_between(x, a, b, 0, mpq_class(i, 64)));
  }
}

TEST(Containment, IsNotFooledByFacesOfNoAreaOrHugeNumbers) {
  const std::vector<Point3> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  EXPECT_TRUE(lies_in({1.5, 1.5, 1.5}, line));
  EXPECT_FALSE(lies_in({1.5, 1.5, 1.25}, line));
  const std::vector<Point3> huge{{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 1e300}};
  EXPECT_TRUE(lies_in({1e299, 1e299, 1e299}, huge));
  EXPECT_FALSE(lies_in({9e299, 9e299, 9e299}, huge));
  const std::vector<Point3> unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_FALSE(lies_in({1e300, 1e300, 1e300}, unit));
}

}  // namespace
}  // namespace certificate
