// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Means of tensors on cells, at their nodes and integration points, and of points in one place.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "field_files.hpp"

namespace tensortopo::test {
namespace {

/// Two tetrahedra with a face in common, the second with thrice the volume of the first.
TextVtu two_cells() {
  TextVtu text;
  text.points = "5", text.cells = "2";
  text.coordinates = "0 0 0  1 0 0  0 1 0  0 0 1  0 0 -3";
  text.connectivity = "0 1 2 3  0 2 1 4", text.offsets = "4 8", text.types = "10 10";
  text.point_data = "";
  text.cell_data = TextVtu::array("S", 6, "1 2 3 0 0 0  5 6 7 0 0 4");
  return text;
}

ReadOptions averaging() {
  ReadOptions options;
  options.cell_to_point = true;
  return options;
}

TEST(CellMeans, PlainAndByVolume) {
  const auto file = put("a.vtu", two_cells().str());
  const auto plain = read_mesh(file, averaging()).mesh.tensors;
  EXPECT_EQ(plain[0].xx, 3);
  EXPECT_EQ(plain[0].xz, 2);
  EXPECT_EQ(plain[3].xx, 1);
  EXPECT_EQ(plain[4].xx, 5);
  ReadOptions options = averaging();
  options.mean = MeanWeights::volume;
  const auto weighted = read_mesh(file, options);
  EXPECT_DOUBLE_EQ(weighted.mesh.tensors[0].xx, (1 + 3 * 5) / 4.);
  EXPECT_DOUBLE_EQ(weighted.mesh.tensors[2].xz, 3);
  EXPECT_EQ(weighted.mesh.tensors[4].xx, 5);
  EXPECT_NE(weighted.report.notes.back().find("by volume"), std::string::npos);
}

TEST(MergePoints, ThatFindsNothingSaysSo) {
  ReadOptions options = averaging();
  options.merge_points = true;
  const auto notes = read_mesh(put("a.vtu", two_cells().str()), options).report.notes;
  EXPECT_EQ(std::count(notes.begin(), notes.end(),
                       "--merge-points: no two points have the same coordinates"),
            1);
}

TEST(CellMeans, MaterialsAreKnownByUsualNames) {
  for (const char* name : {"Material", "mat_id", "gmsh:physical", "medit:ref", "CellEntityIds",
                           "PartId", "RegionId", "domain", "ElSet"}) {
    TextVtu text = two_cells();
    text.cell_data += TextVtu::array(name, 1, "7 2");
    expect_error(put("a.vtu", text.str()), invalid, {"2 materials", name, "--materials none"},
                 averaging());
  }
}

TEST(CellMeans, OfMaterialsAreNeverTakenUnasked) {
  TextVtu text = two_cells();
  text.cell_data += TextVtu::array("MaterialIds", 1, "7 2");
  const auto file = put("a.vtu", text.str());
  expect_error(file, invalid, {"2 materials", "`MaterialIds`", "--materials none"}, averaging());
  ReadOptions options = averaging();
  options.materials = "none";
  EXPECT_EQ(read_mesh(file, options).mesh.tensors[0].xx, 3);
  options.materials = "MaterialIds";
  const auto apart = read_mesh(file, options);
  EXPECT_EQ(apart.report.doubled_vertices, 3u);
  EXPECT_EQ(apart.mesh.points.size(), 8u);
  EXPECT_EQ(apart.report.torn_faces.count, 2u);
  for (std::size_t t = 0; t < 2; ++t)
    for (const auto v : apart.mesh.tets[t])
      EXPECT_EQ(apart.mesh.tensors[static_cast<std::size_t>(v)].xx, t == 0 ? 1 : 5);
  options.materials = "nothing";
  expect_error(file, invalid, {"--materials", "no array `nothing`"}, options);
  text.cell_data = two_cells().cell_data + TextVtu::array("material", 1, "7 7");
  EXPECT_EQ(read_mesh(put("b.vtu", text.str()), averaging()).mesh.points.size(), 5u);
}

TEST(CellMeans, OfTensorsAtNodesOfCells) {
  TextVtu text = two_cells();
  std::string numbers;
  for (int cell = 0; cell < 2; ++cell)
    for (int node = 0; node < 4; ++node)
      numbers += std::to_string(10 * cell + node) + " 0 0 0 0 0 ";
  text.cell_data = TextVtu::array("S", 24, numbers);
  const auto file = put("a.vtu", text.str());
  ReadOptions options;
  options.tensor = "S";
  expect_error(file, invalid, {"24 components"}, options);
  options.cell_values = CellValues::nodes;
  const auto read = read_mesh(file, options);
  EXPECT_EQ(read.mesh.tensors[0].xx, 5);    // node 0 of both
  EXPECT_EQ(read.mesh.tensors[1].xx, 6.5);  // node 1 of the first, 2 of the second
  EXPECT_EQ(read.mesh.tensors[2].xx, 6.5);
  EXPECT_EQ(read.mesh.tensors[3].xx, 3);
  EXPECT_EQ(read.mesh.tensors[4].xx, 13);
  options.tensor = "";
  expect_error(file, inapplicable, {"--cell-values", "--tensor"}, options);
  text.cell_data = TextVtu::array("S", 18,
                                  "1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9 "
                                  "1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9");
  options.tensor = "S";
  expect_error(put("b.vtu", text.str()), invalid, {"4 nodes", "18 components"}, options);
}

TEST(CellMeans, OfIntegrationPoints) {
  TextVtu text = two_cells();
  text.cell_data = TextVtu::array("S", 12, "1 0 0 0 0 0  3 0 0 0 0 0   6 0 0 0 0 0  8 0 0 0 0 0");
  ReadOptions options;
  options.tensor = "S";
  options.cell_values = CellValues::points;
  const auto read = read_mesh(put("a.vtu", text.str()), options);
  EXPECT_EQ(read.mesh.tensors[3].xx, 2);
  EXPECT_EQ(read.mesh.tensors[4].xx, 7);
  EXPECT_EQ(read.mesh.tensors[0].xx, 4.5);
  text.cell_data = TextVtu::array("S", 18,
                                  "1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9 "
                                  "1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9");
  expect_error(put("b.vtu", text.str()), invalid, {"of 6 or of 9", "--components"}, options);
  options.components = ComponentOrder::abaqus;
  EXPECT_EQ(read_mesh(put("b.vtu", text.str()), options).mesh.tensors[3].xy, (4 + 1 + 7) / 3.);
}

/// The same two cells, each with points of its own.
TextVtu torn_cells(const std::string& second) {
  TextVtu text;
  text.points = "8", text.cells = "2";
  text.coordinates = "0 0 0  1 0 0  0 1 0  0 0 1   0 0 0  0 1 0  1 0 0  0 0 -3";
  text.connectivity = "0 1 2 3  4 5 6 7", text.offsets = "4 8", text.types = "10 10";
  text.point_data =
      TextVtu::array("S", 6, "1 0 0 0 0 0  2 0 0 0 0 0  3 0 0 0 0 0  4 0 0 0 0 0 " + second);
  return text;
}

TEST(MergePoints, EqualOnesBecomeOne) {
  const auto file =
      put("a.vtu", torn_cells("1 0 0 0 0 0  3 0 0 0 0 0  2 0 0 0 0 0  9 0 0 0 0 0").str());
  const auto torn = read_mesh(file);
  EXPECT_EQ(torn.report.torn_faces.count, 2u);
  EXPECT_NE(torn.report.notes.back().find("--merge-points"), std::string::npos)
      << torn.report.notes.back();
  ReadOptions options;
  options.merge_points = true;
  const auto merged = read_mesh(file, options);
  EXPECT_EQ(merged.mesh.points.size(), 5u);
  EXPECT_EQ(merged.report.merged_points, 3u);
  EXPECT_EQ(merged.report.torn_faces.count, 0u);
}

TEST(MergePoints, OthersOnlyIfAskedForTheirMean) {
  TextVtu text = torn_cells("5 0 0 0 0 0  3 0 0 0 0 0  2 0 0 0 0 0  9 0 0 0 0 0");
  ReadOptions options;
  options.merge_points = true;
  const auto file = put("a.vtu", text.str());
  EXPECT_EQ(read_mesh(file, options).mesh.points.size(), 6u);
  options.mean = MeanWeights::plain;
  auto read = read_mesh(file, options);
  EXPECT_EQ(read.mesh.points.size(), 5u);
  EXPECT_EQ(read.mesh.tensors[0].xx, 3);
  options.mean = MeanWeights::volume;
  text.cell_data = TextVtu::array("material", 1, "1 2");
  const auto materials = put("b.vtu", text.str());
  expect_error(materials, invalid, {"2 materials"}, options);
  options.materials = "material";
  EXPECT_EQ(read_mesh(materials, options).mesh.points.size(), 8u);
  options.materials = "none";
  read = read_mesh(materials, options);
  EXPECT_EQ(read.mesh.points.size(), 5u);
  options.merge_points = false;
  expect_error(materials, inapplicable, {"--mean", "--merge-points"}, options);
}

}  // namespace
}  // namespace tensortopo::test
