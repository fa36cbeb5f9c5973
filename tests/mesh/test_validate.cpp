// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/validate.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "plain_mesh.hpp"

namespace tensortopo {
namespace {

using Kind = MeshDefect::Kind;

const std::vector<Vector3<double>> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};

std::vector<Kind> kinds(const TetMesh& mesh) {
  std::vector<Kind> found;
  for (const MeshDefect& defect : validate(mesh)) found.push_back(defect.kind);
  return found;
}

TEST(Validate, AcceptsTwoTetrahedraOnTheTwoSidesOfAFace) {
  EXPECT_TRUE(validate(plain_mesh(corner, {{0, 1, 2, 3}, {4, 1, 3, 2}})).empty());
}

TEST(Validate, AcceptsAnEmptyMesh) { EXPECT_TRUE(validate(TetMesh{}).empty()); }

TEST(Validate, NamesAnInvertedTetrahedronAndRepairTurnsIt) {
  TetMesh mesh = plain_mesh(corner, {{0, 2, 1, 3}, {4, 1, 3, 2}});
  const auto defects = validate(mesh);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Kind::inverted_cell);
  EXPECT_EQ(defects[0].where, 100);
  EXPECT_NE(defects[0].text.find("cell 100"), std::string::npos);
  EXPECT_EQ(repair_orientation(mesh), 1u);
  EXPECT_EQ(mesh.tets[0], (std::array<int, 4>{0, 2, 3, 1}));
  EXPECT_TRUE(validate(mesh).empty());
  EXPECT_EQ(repair_orientation(mesh), 0u);
}

TEST(Validate, DecidesFlatnessExactly) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double scale : {1.0, 1e99, 1e-99, 0x1p-330}) {
    auto points = corner;
    for (auto& p : points) p = scale * p;
    points[3] = Vector3<double>{scale / 4, scale / 2, 0};
    EXPECT_EQ(kinds(plain_mesh(points, {{0, 1, 2, 3}})), std::vector{Kind::degenerate_cell})
        << scale;
    points[3].z = tiny;
    EXPECT_TRUE(kinds(plain_mesh(points, {{0, 1, 2, 3}})).empty()) << scale;
    points[3].z = -tiny;
    EXPECT_EQ(kinds(plain_mesh(points, {{0, 1, 2, 3}})), std::vector{Kind::inverted_cell}) << scale;
  }
}

TEST(Validate, NamesCoordinatesWhoseProductsAreNoDoubles) {
  const auto scaled = [](double scale) {
    auto points = corner;
    for (auto& p : points) p = scale * p;
    return plain_mesh(points, {{0, 1, 2, 3}});
  };
  for (const double scale : {1e100, 1e-100, 1.0}) EXPECT_TRUE(validate(scaled(scale)).empty());
  const auto large = validate(scaled(1e101)), small = validate(scaled(1e-101));
  ASSERT_FALSE(large.empty());
  EXPECT_EQ(large[0].kind, Kind::out_of_range);
  EXPECT_EQ(large[0].text, "point 1 has a coordinate beyond 1e100, too large for products");
  ASSERT_EQ(small.size(), 1u);
  EXPECT_EQ(small[0].kind, Kind::out_of_range);
  EXPECT_EQ(small[0].where, 100);
}

TEST(Validate, NamesRepeatedVerticesAndIndicesOutOfRange) {
  const auto mesh = plain_mesh(corner, {{0, 1, 2, 2}, {0, 1, 2, 5}, {-1, 1, 2, 3}});
  EXPECT_EQ(kinds(mesh), (std::vector{Kind::repeated_vertex, Kind::index_out_of_range,
                                      Kind::index_out_of_range}));
  EXPECT_EQ(validate(mesh)[2].where, 102);
}

TEST(Validate, NamesADuplicateOnceWhateverItsOrder) {
  const auto mesh = plain_mesh(corner, {{0, 1, 2, 3}, {4, 1, 3, 2}, {1, 2, 0, 3}});
  const auto defects = validate(mesh);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Kind::duplicated_cell);
  EXPECT_EQ(defects[0].where, 102);
  EXPECT_NE(defects[0].text.find("cell 100"), std::string::npos);
}

TEST(Validate, NamesAFaceOfThree) {
  auto points = corner;
  points.push_back({2, 2, 2});
  const auto mesh = plain_mesh(points, {{0, 1, 2, 3}, {4, 1, 3, 2}, {5, 1, 3, 2}});
  const auto defects = validate(mesh);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Kind::crowded_face);
  EXPECT_NE(defects[0].text.find("face 1 2 3"), std::string::npos);
}

TEST(Validate, NamesTwoTetrahedraOnOneSideOfTheirFace) {
  auto points = corner;
  points[4] = {-1, -1, -1};
  TetMesh mesh = plain_mesh(points, {{0, 1, 2, 3}, {4, 1, 3, 2}});
  repair_orientation(mesh);
  EXPECT_EQ(kinds(mesh), std::vector{Kind::overlapping_cells});
}

TEST(Validate, OverlapIsSeenThroughInvertedCells) {
  const auto mesh = plain_mesh(corner, {{0, 2, 1, 3}, {4, 1, 2, 3}});
  EXPECT_EQ(kinds(mesh), (std::vector{Kind::inverted_cell, Kind::inverted_cell}));
}

TEST(Validate, NamesNumbersThatAreNotFinite) {
  TetMesh mesh = plain_mesh(corner, {{0, 1, 2, 3}});
  mesh.points[4].y = std::numeric_limits<double>::quiet_NaN();
  mesh.tensors[2].xz = std::numeric_limits<double>::infinity();
  const auto defects = validate(mesh);
  ASSERT_EQ(defects.size(), 2u);
  EXPECT_EQ(defects[0].kind, Kind::non_finite_tensor);
  EXPECT_EQ(defects[0].where, 2);
  EXPECT_EQ(defects[1].kind, Kind::non_finite_point);
  EXPECT_EQ(defects[1].where, 4);
  mesh.points[0].x = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(kinds(mesh).size(), 3u);
}

TEST(Validate, NamesArraysOfTheWrongLength) {
  TetMesh mesh = plain_mesh(corner, {{0, 1, 2, 3}});
  mesh.tensors.pop_back();
  mesh.cell_ids.clear();
  EXPECT_EQ(kinds(mesh), (std::vector{Kind::wrong_length, Kind::wrong_length}));
}

TEST(Validate, AllowsAndCountsUnreferencedPoints) {
  const auto mesh = plain_mesh(corner, {{0, 1, 2, 3}});
  EXPECT_TRUE(validate(mesh).empty());
  EXPECT_EQ(count_unreferenced_points(mesh), 1u);
}

TEST(Validate, ListsAtMostAThousandDefects) {
  EXPECT_EQ(
      validate(plain_mesh(corner, std::vector<std::array<int, 4>>(5000, {0, 0, 0, 0}))).size(),
      1000u);
}

TEST(Validate, JudgesManyCopiesInReasonableTime) {
  EXPECT_EQ(
      validate(plain_mesh(corner, std::vector<std::array<int, 4>>(20000, {0, 1, 2, 3}))).size(),
      1000u);
}

}  // namespace
}  // namespace tensortopo
