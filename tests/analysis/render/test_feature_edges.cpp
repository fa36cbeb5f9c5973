// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/input/feature_edges.hpp"

namespace tensortopo::test {
namespace {

using Index = SurfaceMesh::Index;

// A strip of n squares along y, the next to it raised by an angle.
SurfaceMesh folded(int n, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  SurfaceMesh sheet;
  for (int j = 0; j <= n; ++j) {
    const double y = j;
    sheet.points.insert(sheet.points.end(), {{-1, y, 0}, {0, y, 0}});
    sheet.points.push_back({std::cos(angle), y, std::sin(angle)});
  }
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < 2; ++i) {
      const Index a = 3 * j + i;
      sheet.triangles.insert(sheet.triangles.end(), {{a, a + 1, a + 4}, {a, a + 4, a + 3}});
    }
  return sheet;
}

RC_GTEST_PROP(FeatureEdges, OfAFoldedSheetAreItsRimAndItsFold, ()) {
  const int n = *rc::gen::inRange(1, 9);
  const double degrees = *rc::gen::inRange(-160, 161);
  RC_PRE(std::abs(std::abs(degrees) - kFeatureAngle) > 0.5);
  const SurfaceMesh sheet = folded(n, degrees);
  const auto rim = feature_edges(sheet, EdgeKind::boundary);
  RC_ASSERT(rim.size() == static_cast<std::size_t>(2 * n + 4));
  for (const auto& [from, to] : rim) {
    const auto [low, high] = std::minmax(from, to);
    const bool along = low % 3 == high % 3;
    const bool across = low / 3 == high / 3 && (low < 3 || low / 3 == n);
    RC_ASSERT((along ? low % 3 != 1 : across));
  }
  const auto creases = feature_edges(sheet, EdgeKind::crease);
  const int folds = std::abs(degrees) > kFeatureAngle ? n : 0;
  RC_ASSERT(creases.size() == static_cast<std::size_t>(folds));
  for (const auto& [from, to] : creases) RC_ASSERT((from % 3 == 1 && std::abs(to - from) == 3));
}

// What is drawn is the same, byte by byte, only if the lines are.
RC_GTEST_PROP(FeatureEdges, DoNotDependOnHowVerticesAreNumbered, ()) {
  const SurfaceMesh sheet = folded(*rc::gen::inRange(1, 9), 40);
  SurfaceMesh other = sheet;
  const auto last = static_cast<Index>(sheet.points.size()) - 1;
  std::reverse(other.points.begin(), other.points.end());
  for (auto& t : other.triangles)
    for (Index& v : t) v = last - v;
  for (const EdgeKind kind : {EdgeKind::boundary, EdgeKind::crease}) {
    auto edges = feature_edges(other, kind);
    for (auto& edge : edges)
      for (Index& v : edge) v = last - v;
    RC_ASSERT((edges == feature_edges(sheet, kind)));
  }
}

// Three triangles at an edge make neither; triangles without common vertices are all rim.
TEST(FeatureEdges, AreToldApartByTheNumbersOfTheirVertices) {
  SurfaceMesh book;
  book.points = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, 0}, {0, 1, 0}};
  book.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_EQ(feature_edges(book, EdgeKind::boundary).size(), 6u);
  EXPECT_TRUE(feature_edges(book, EdgeKind::crease).empty());
  book.triangles[2] = {5, 6, 4};
  const auto rim = feature_edges(book, EdgeKind::boundary);
  EXPECT_EQ(rim.size(), 7u);
  for (const auto& [from, to] : rim) EXPECT_NE(from + to, 1);
}

}  // namespace
}  // namespace tensortopo::test
