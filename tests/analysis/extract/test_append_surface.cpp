// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <stdexcept>

#include "tensortopo/mesh/append_surface.hpp"

namespace tensortopo {
namespace {

SurfaceMesh two_triangles(double mode) {
  SurfaceMesh s;
  s.points = {{0, 0, mode}, {1, 0, mode}, {0, 1, mode}, {1, 1, mode}, {2, 1, mode}, {1, 2, mode}};
  s.triangles = {{0, 1, 2}, {3, 4, 5}};
  s.mode.assign(6, mode);
  s.component = {0, 1};
  s.tet = {7, 8};
  return s;
}

TEST(AppendSurface, ToNothingGivesThePart) {
  SurfaceMesh surface;
  append_surface(surface, two_triangles(0.5));
  EXPECT_EQ(surface.triangles, two_triangles(0.5).triangles);
  EXPECT_EQ(surface.points, two_triangles(0.5).points);
}

TEST(AppendSurface, NothingChangesNothing) {
  SurfaceMesh surface = two_triangles(0.5);
  append_surface(surface, {});
  EXPECT_EQ(surface.triangles, two_triangles(0.5).triangles);
}

TEST(AppendSurface, NumbersVerticesAndComponentsAcrossSurfaces) {
  SurfaceMesh surface = two_triangles(0.5);
  append_surface(surface, two_triangles(-0.5));
  ASSERT_EQ(surface.points.size(), 12u);
  EXPECT_EQ(surface.triangles[0], (std::array<SurfaceMesh::Index, 3>{0, 1, 2}));
  EXPECT_EQ(surface.triangles[3], (std::array<SurfaceMesh::Index, 3>{9, 10, 11}));
  EXPECT_EQ(surface.component, (std::vector<SurfaceMesh::Index>{0, 1, 2, 3}));
  EXPECT_EQ(surface.tet, (std::vector<SurfaceMesh::Index>{7, 8, 7, 8}));
  EXPECT_EQ(surface.mode[5], 0.5);
  EXPECT_EQ(surface.mode[6], -0.5);
}

TEST(AppendSurface, RefusesHalfFilledArrays) {
  SurfaceMesh surface = two_triangles(0.5), part = two_triangles(-0.5);
  part.mode.clear();
  EXPECT_THROW(append_surface(surface, part), std::invalid_argument);
}

CurveMesh two_lines(double mode) {
  CurveMesh c;
  c.points = {{0, 0, mode}, {1, 0, mode}, {0, 1, mode}};
  c.lines = {{0, 1}, {1, 2}};
  c.mode.assign(3, mode);
  c.component = {0, 0};
  c.tet = {7, 8};
  return c;
}

TEST(AppendCurves, NumbersVerticesAndComponentsAcrossCurves) {
  CurveMesh curves;
  append_curves(curves, two_lines(1));
  append_curves(curves, {});
  append_curves(curves, two_lines(-1));
  ASSERT_EQ(curves.points.size(), 6u);
  EXPECT_EQ(curves.lines[1], (std::vector<CurveMesh::Index>{1, 2}));
  EXPECT_EQ(curves.lines[3], (std::vector<CurveMesh::Index>{4, 5}));
  EXPECT_EQ(curves.component, (std::vector<CurveMesh::Index>{0, 0, 1, 1}));
  EXPECT_EQ(curves.tet, (std::vector<CurveMesh::Index>{7, 8, 7, 8}));
  EXPECT_EQ(curves.mode[3], -1);
}

TEST(AppendCurves, RefusesHalfFilledArrays) {
  CurveMesh curves = two_lines(1), part = two_lines(-1);
  part.tet.clear();
  EXPECT_THROW(append_curves(curves, part), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo
