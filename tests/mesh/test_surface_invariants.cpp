// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/surface_invariants.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace tensortopo {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

SurfaceMesh surface_of(std::size_t points, Triangles triangles) {
  SurfaceMesh surface;
  for (std::size_t i = 0; i < points; ++i) {
    const double t = static_cast<double>(i);
    surface.points.push_back({std::cos(t), std::sin(t), t * t / 7});
  }
  surface.triangles = std::move(triangles);
  return surface;
}

/// A rows x columns grid of squares, glued around in one direction or both; `flip` glues the
/// columns' ends upside down.
SurfaceMesh grid(int rows, int columns, bool glue_rows, bool glue_columns, bool flip = false) {
  const int height = glue_rows ? rows : rows + 1, width = glue_columns ? columns : columns + 1;
  const auto at = [&](int i, int j) {
    if (glue_columns && j >= width) {
      j -= width;
      if (flip) i = rows - i;
    }
    if (glue_rows) i %= height;
    return i * width + j;
  };
  Triangles triangles;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return surface_of(static_cast<std::size_t>(height * width), triangles);
}

const Triangles tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

/// The projective plane with six vertices.
const Triangles projective_plane{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                                 {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};

struct Expected {
  const char* name;
  SurfaceMesh surface;
  long euler, loops, genus;
  bool orientable, closed, manifold;
};

TEST(SurfaceInvariants, OfKnownConnectedSurfaces) {
  const std::vector<Expected> table{
      {"triangle", surface_of(3, {{0, 1, 2}}), 1, 1, 0, true, false, true},
      {"sphere", surface_of(4, tetrahedron), 2, 0, 0, true, true, true},
      {"disk", grid(3, 4, false, false), 1, 1, 0, true, false, true},
      {"annulus", grid(2, 5, false, true), 0, 2, 0, true, false, true},
      {"torus", grid(4, 5, true, true), 0, 0, 1, true, true, true},
      {"Moebius band", grid(2, 5, false, true, true), 0, 1, 1, false, false, true},
      {"projective plane", surface_of(6, projective_plane), 1, 0, 1, false, true, true},
      {"two triangles at a vertex", surface_of(5, {{0, 1, 2}, {0, 3, 4}}), 1, 1, -1, true, false,
       false},
      {"three triangles at an edge", surface_of(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), 1, 1, -1,
       true, false, false},
      {"a triangle twice", surface_of(3, {{0, 1, 2}, {0, 2, 1}}), 2, 0, -1, true, true, false},
  };
  for (const Expected& e : table) {
    const SurfaceInvariants s = surface_invariants(e.surface);
    EXPECT_EQ(s.components, 1u) << e.name;
    EXPECT_EQ(s.euler_characteristic, e.euler) << e.name;
    EXPECT_EQ(s.boundary_loops, e.loops) << e.name;
    EXPECT_EQ(s.orientable, e.orientable) << e.name;
    EXPECT_EQ(s.closed, e.closed) << e.name;
    EXPECT_EQ(s.manifold, e.manifold) << e.name;
    ASSERT_EQ(s.parts.size(), 1u) << e.name;
    EXPECT_EQ(s.parts[0].genus, e.genus) << e.name;
    EXPECT_EQ(s.parts[0].triangles, e.surface.triangles.size()) << e.name;
  }
}

TEST(SurfaceInvariants, TellOrientableFromOriented) {
  Triangles turned = tetrahedron;
  EXPECT_TRUE(surface_invariants(surface_of(4, turned)).consistently_oriented);
  std::swap(turned[2][0], turned[2][1]);
  const auto s = surface_invariants(surface_of(4, turned));
  EXPECT_TRUE(s.orientable);
  EXPECT_FALSE(s.consistently_oriented);
  EXPECT_TRUE(s.manifold);
}

TEST(SurfaceInvariants, TwoSpheresThatTouchAreOneComponentAndNoManifold) {
  Triangles both = tetrahedron;
  for (const auto& t : tetrahedron)
    both.push_back({t[0] == 0 ? 0 : t[0] + 3, t[1] == 0 ? 0 : t[1] + 3, t[2] == 0 ? 0 : t[2] + 3});
  const auto s = surface_invariants(surface_of(7, both));
  EXPECT_EQ(s.components, 1u);
  EXPECT_EQ(s.euler_characteristic, 3);
  EXPECT_TRUE(s.closed);
  EXPECT_TRUE(s.orientable);
  EXPECT_FALSE(s.manifold);
}

TEST(SurfaceInvariants, PartsAreNumberedByFirstTriangleAndSumToTheWhole) {
  Triangles mixed{{10, 11, 12}};
  mixed.insert(mixed.end(), tetrahedron.begin(), tetrahedron.end());
  mixed.push_back({10, 12, 13});
  const auto s = surface_invariants(surface_of(20, mixed));
  EXPECT_EQ(s.component, (std::vector<int>{0, 1, 1, 1, 1, 0}));
  EXPECT_EQ(surface_components(surface_of(20, mixed)), s.component);
  ASSERT_EQ(s.parts.size(), 2u);
  EXPECT_EQ(s.parts[0].euler_characteristic, 1);
  EXPECT_EQ(s.parts[0].boundary_loops, 1);
  EXPECT_EQ(s.parts[0].triangles, 2u);
  EXPECT_EQ(s.parts[1].euler_characteristic, 2);
  EXPECT_EQ(s.euler_characteristic, 3);
  EXPECT_EQ(s.vertices, 8u);
  EXPECT_DOUBLE_EQ(s.area, s.parts[0].area + s.parts[1].area);
  EXPECT_FALSE(s.closed);
}

TEST(SurfaceInvariants, AreaOfTheUnitCornerTriangle) {
  SurfaceMesh surface;
  surface.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  surface.triangles = {{0, 1, 2}};
  EXPECT_NEAR(surface_invariants(surface).area, std::sqrt(3.0) / 2, 1e-15);
}

TEST(SurfaceInvariants, OfNothing) {
  const auto s = surface_invariants(SurfaceMesh{});
  EXPECT_EQ(s.components, 0u);
  EXPECT_EQ(s.euler_characteristic, 0);
  EXPECT_TRUE(s.closed && s.manifold && s.orientable);
}

TEST(SurfaceInvariants, ARepeatedVertexIsNoManifold) {
  EXPECT_FALSE(surface_invariants(surface_of(2, {{0, 0, 1}})).manifold);
  EXPECT_FALSE(surface_invariants(surface_of(1, {{0, 0, 0}})).manifold);
}

TEST(SurfaceInvariants, RefuseAnIndexOutOfRange) {
  EXPECT_THROW(surface_invariants(surface_of(2, {{0, 1, 2}})), std::invalid_argument);
  EXPECT_THROW(surface_invariants(surface_of(2, {{0, 1, -1}})), std::invalid_argument);
}

TEST(SurfaceInvariants, DoNotDependOnTheOrderOfTriangles) {
  SurfaceMesh surface = grid(6, 7, false, true, true);
  const auto before = surface_invariants(surface);
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(surface.triangles.begin(), surface.triangles.end(), random);
    for (auto& t : surface.triangles) std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    const auto after = surface_invariants(surface);
    EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
    EXPECT_EQ(after.boundary_loops, before.boundary_loops);
    EXPECT_EQ(after.orientable, before.orientable);
    EXPECT_EQ(after.manifold, before.manifold);
    EXPECT_NEAR(after.area, before.area, 1e-9 * before.area);
  }
}

}  // namespace
}  // namespace tensortopo
