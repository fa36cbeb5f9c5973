// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/chart_triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace tensortopo::test {
namespace {

using Point = ChartTriangulation::Point;
using Segments = std::vector<std::array<std::size_t, 2>>;
using Cut = ChartTriangulation::Cut;

Segments closed(std::size_t first, std::size_t count) {
  Segments segments;
  for (std::size_t i = 0; i < count; ++i) segments.push_back({first + i, first + (i + 1) % count});
  return segments;
}

std::vector<Point> circle(std::size_t count, double radius) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

/// Of a build without more points.
std::optional<std::vector<ChartTriangulation::Triangle>> triangles(
    const std::vector<Point>& points, const Segments& segments,
    const std::vector<Point>& samples = {}) {
  ChartTriangulation triangulation;
  const bool is_built = triangulation.build(
      points, segments, [&](const auto&) { return samples; },
      [](const auto& all) { return std::vector<Cut>(all.size(), Cut::none); },
      [](const auto&) { return std::nullopt; }, 1);
  if (!is_built) return std::nullopt;
  return triangulation.triangles;
}

TEST(ChartTriangulation, CoversTheRegionsOnly) {
  auto points = circle(12, 3);
  auto segments = closed(0, 12);
  EXPECT_EQ(triangles(points, segments)->size(), 10u);
  const auto hole = circle(6, 1);
  points.insert(points.end(), hole.begin(), hole.end());
  const auto around = closed(12, 6);
  segments.insert(segments.end(), around.begin(), around.end());
  EXPECT_EQ(triangles(points, segments)->size(), 18u) << "as many as corners, in a ring";
  EXPECT_EQ(triangles(points, segments, {{2, 0.25}, {0, -1.5}, {0, 0.5}})->size(), 22u)
      << "two more for each sample in the ring";
}

TEST(ChartTriangulation, HasNoTrianglesOfPointsOnALine) {
  EXPECT_EQ(triangles({}, {})->size(), 0u);
  EXPECT_EQ(triangles({{0, 0}, {1, 2}, {2, 4}}, {{0, 1}, {1, 2}})->size(), 0u);
}

TEST(ChartTriangulation, RefusesCrossingsAndCopies) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_TRUE(triangles(square, closed(0, 4)));
  EXPECT_FALSE(triangles({square[0], square[2], square[1], square[3]}, closed(0, 4)));
  EXPECT_FALSE(triangles({{0, 0}, {1, 0}, {1, 1}, {1, 0}}, closed(0, 4)));
  EXPECT_FALSE(triangles(square, closed(0, 4), {{0.5, 0.5}, {0.5, 0.5}}));
  EXPECT_FALSE(triangles(square, closed(0, 4), {{0.5, 0}})) << "a sample on the outline";
  EXPECT_FALSE(triangles({{0, 0}, {2, 0}, {1, 0}, {1, 1}}, closed(0, 4))) << "covered twice";
  EXPECT_FALSE(triangles({{0, 0}, {1, 0}, {NAN, 1}}, closed(0, 3)));
}

TEST(ChartTriangulation, TellsHowFarPlacesAreFromTheOutline) {
  // Outer radii of a polar layout are about 2^860.
  for (const int exponent : {0, -700, -300, 300, 600, 860}) {
    const auto times = [exponent](const Point& p) {
      return Point{std::ldexp(p[0], exponent), std::ldexp(p[1], exponent)};
    };
    ChartTriangulation triangulation;
    std::vector<double> found;
    triangulation.build(
        {times({0, 0}), times({8, 0}), times({8, 8}), times({0, 8})}, closed(0, 4),
        [&](const auto& clearance) {
          for (const Point& at : {Point{4, 1}, Point{4, 4}, Point{-1, 4}, Point{9, 9}}) {
            const double far = clearance(times(at));
            found.push_back(far < 0 ? far : std::ldexp(far, -exponent));
          }
          return std::vector<Point>();
        },
        [](const auto& all) { return std::vector<Cut>(all.size(), Cut::none); },
        [](const auto&) { return std::nullopt; }, 0);
    EXPECT_EQ(found, (std::vector<double>{std::sqrt(2.5), std::sqrt(32), -1, -1})) << exponent;
  }
}

TEST(ChartTriangulation, InsertsWhatIsAskedForAsOftenAsThereAreRounds) {
  for (int rounds = 0; rounds < 4; ++rounds) {
    ChartTriangulation triangulation;
    int asked = 0;
    std::vector<Point> added;
    EXPECT_TRUE(triangulation.build(
        circle(9, 1), closed(0, 9), [](const auto&) { return std::vector<Point>(); },
        [&](const auto& all) {
          ++asked;
          return std::vector<Cut>(all.size(), Cut::amid);
        },
        [&](const ChartTriangulation::Place& place) {
          double sum = 0;
          for (const double w : place.weights) {
            EXPECT_GE(w, 0);
            sum += w;
          }
          EXPECT_NEAR(sum, 1, 1e-12);
          EXPECT_LT(std::hypot(place.at[0], place.at[1]), 1);
          added.push_back(place.at);
          return std::optional(place.at);
        },
        rounds));
    EXPECT_EQ(asked, rounds);
    EXPECT_EQ(triangulation.triangles.size(), 7 + 2 * added.size());
    EXPECT_TRUE(std::is_sorted(triangulation.triangles.begin(), triangulation.triangles.end()));
    EXPECT_GE(added.size(), static_cast<std::size_t>(rounds));
  }
}

TEST(ChartTriangulation, TakesLongOutlines) {
  constexpr std::size_t count = 40000;
  auto points = circle(count, 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double factor = 1 + 0.3 * std::sin(0.01 * static_cast<double>(i));
    for (double& x : points[i]) x *= factor;
  }
  EXPECT_EQ(triangles(points, closed(0, count))->size(), count - 2);
}

}  // namespace
}  // namespace tensortopo::test
