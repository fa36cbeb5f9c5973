// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "embedding/surface_defects.hpp"

namespace tensortopo::embedding {
namespace {

using Where = Intersection::Where;

Surface surface(std::vector<Point> points, std::vector<std::array<std::int32_t, 3>> triangles,
                std::vector<std::int32_t> tets = {}) {
  tets.resize(triangles.size(), 0);
  return {std::move(points), std::move(triangles), std::move(tets)};
}

std::size_t pairs(const Surface& s) { return intersections(s).pairs.size(); }

TEST(Intersections, OfTrianglesWithoutACommonVertex) {
  const std::vector<Point> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1},
                                  {5, 5, 1}, {1, 1, 0}, {9, 9, 1}, {9, 9, -1}, {1, 1, 0x1p-60}};
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {3, 4, 5}})), 1u);
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {4, 5, 7}})), 0u);
  // They touch in a point.
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {6, 4, 5}})), 1u);
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {9, 4, 5}})), 0u);
}

TEST(Intersections, OfTrianglesWithCommonVertices) {
  const std::vector<Point> points{{0, 0, 0},  {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 2, -1},
                                  {-1, 1, 1}, {3, 3, 0}, {1, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {0, 3, 4}})), 1u);  // from the vertex on
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {0, 3, 5}})), 0u);
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {2, 1, 6}})), 0u);  // on either side of an edge
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {1, 2, 7}})), 1u);  // folded on it
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {1, 2, 8}})), 0u);
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {1, 2, 0}})), 1u);
}

TEST(Intersections, VerticesAtOnePlaceAreOne) {
  const std::vector<Point> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0},
                                  {0, 0, 0}, {0, 0, 4}, {-4, 0, 1}};
  EXPECT_EQ(pairs(surface(points, {{0, 1, 2}, {3, 4, 5}})), 0u);
  EXPECT_EQ(intersections(surface(points, {{0, 1, 2}, {0, 3, 4}})).without_area, 1u);
}

TEST(Intersections, SayWhetherOneSheetOrTetrahedronHasBoth) {
  const std::vector<Point> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1},
                                  {1, 1, 1}, {5, 5, 1}, {9, 0, 0}};
  const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 2}, {3, 4, 5}, {1, 6, 5}};
  const auto where = [&](const std::vector<std::int32_t>& tets) {
    return intersections(surface(points, triangles, tets)).pairs.at(0).where;
  };
  EXPECT_EQ(where({0, 0, 0}), Where::one_sheet);  // the third joins them
  EXPECT_EQ(where({0, 0, 1}), Where::two_sheets);
  EXPECT_EQ(where({0, 1, 0}), Where::two_tets);
}

/// diag(1 + x, -1 + x, -2 x): neutral on x = 0, and the mode rises with x.
Field tilted() {
  Field field;
  field.points = {{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}};
  for (const auto& p : field.points)
    field.tensors.push_back({1 + p[0], -1 + p[0], -2 * p[0], 0, 0, 0});
  field.tets = {{0, 1, 2, 3}};
  return field;
}

TEST(AgainstGradient, IsTheSideOfTheNormal) {
  const std::vector<Point> points{{0, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0x1p-40, 0, 0.5}};
  const auto count = [&](const std::array<std::int32_t, 3>& triangle) {
    const auto found = against_gradient(surface(points, {triangle}), tilted());
    EXPECT_EQ(found.compared, 1u);
    EXPECT_EQ(found.at_corners, found.at_centroid.size());
    return found.at_centroid.size();
  };
  EXPECT_EQ(count({0, 1, 2}), 0u);
  EXPECT_EQ(count({0, 2, 1}), 1u);
  EXPECT_EQ(count({0, 1, 3}), 0u);
}

TEST(Residuals, AreThoseOfTheVertices) {
  std::vector<Point> points{{0, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}};
  const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 2}};
  const auto on = residuals(surface(points, triangles), tilted(), {0, 1});
  EXPECT_EQ(on.largest, 0);
  EXPECT_EQ(on.off.size(), 0u);
  EXPECT_EQ(on.compared, 3u);
  // Next to x = 0 the mode is 3 sqrt(6) 2 x / sqrt(2)^3 to first order.
  points[0][0] = 0x1p-20;
  const auto off = residuals(surface(points, triangles), tilted(), {0, 1});
  EXPECT_NEAR(off.largest, 3 * std::sqrt(3.0) * 0x1p-20, 1e-9);
  EXPECT_EQ(off.off.size(), 1u);
  // Squares are compared where the mode asked for has the sign of the vertices'.
  const auto half = residuals(surface(points, triangles), tilted(), {1, 1 << 20});
  EXPECT_NEAR(half.largest, 3 * std::sqrt(3.0) * 0x1p-20 - 0x1p-20, 1e-9);
  EXPECT_EQ(half.off.size(), 3u);
}

}  // namespace
}  // namespace tensortopo::embedding
