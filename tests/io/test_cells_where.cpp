// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Conditions that choose the cells of a field.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "field_files.hpp"
#include "support/compared.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

constexpr auto kInapplicable = IoError::Kind::inapplicable;

/// Two tetrahedra with a face in common, of the points 0 1 2 3 and 0 2 1 4.
TextVtu cells_with_arrays() {
  TextVtu text;
  text.points = "5", text.cells = "2";
  text.coordinates = "0 0 0  1 0 0  0 1 0  0 0 1  0 0 -3";
  text.connectivity = "0 1 2 3  0 2 1 4", text.offsets = "4 8", text.types = "10 10";
  text.point_data = TextVtu::array(
      "stress", 6, "1 2 3 0 0 0  5 6 7 0 0 4  1 1 1 1 0 0  2 2 2 0 1 0  3 3 3 0 0 0");
  text.point_data += TextVtu::array("FA", 1, "1 1 1 0.5 0") + TextVtu::array("fa", 1, "0 0 0 0 0") +
                     TextVtu::array("v", 3, "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1") +
                     TextVtu::array("odd name", 1, "1 1 1 1 nan");
  text.cell_data = TextVtu::array("region", 1, "7 8");
  return text;
}

std::vector<std::int64_t> taken(const std::filesystem::path& file, const std::string& where) {
  ReadOptions options;
  options.tensor = "stress";
  options.where = where;
  return read_mesh(file, options).mesh.cell_ids;
}

TEST(CellsWhere, ConditionHoldsAtAllNodesAndInTheCell) {
  const auto file = put("a.vtu", cells_with_arrays().str());
  const std::vector<std::int64_t> first{0}, second{1}, both{0, 1};
  EXPECT_EQ(taken(file, "FA"), first);
  EXPECT_EQ(taken(file, "FA > 0.2"), first);
  EXPECT_EQ(taken(file, "FA >= 0"), both);
  EXPECT_EQ(taken(file, "z <= 0"), second);
  EXPECT_EQ(taken(file, "region"), both);
  EXPECT_EQ(taken(file, "region > 7"), second);
  EXPECT_EQ(taken(file, "region == 7 and FA > 0.2"), first);
  EXPECT_EQ(taken(file, "region == 8 or FA > 0.2"), both);
  // The isotropic tensor of point 4 has no mode, and a number that is none is no number.
  EXPECT_EQ(taken(file, "mode >= -1"), first);
  EXPECT_EQ(taken(file, "odd name"), first);
  EXPECT_EQ(taken(file, "\"odd name\" > 0"), first);
  EXPECT_EQ(taken(file, "deviator_magnitude > 1e-9"), first);
}

TEST(CellsWhere, IsRefusedWithWhatThereIs) {
  const auto file = put("a.vtu", cells_with_arrays().str());
  ReadOptions options;
  options.tensor = "stress";
  const auto expect = [&](const std::string& where, IoError::Kind kind,
                          const std::vector<std::string>& parts) {
    options.where = where;
    expect_error(file, kind, parts, options);
  };
  expect("nothing > 3", kInapplicable, {"--where 'nothing > 3'", "FA", "region", "anisotropy"});
  expect("FA >", kInapplicable, {"--where 'FA >'"});
  expect("v > 0", kInapplicable, {"--where 'v > 0'"});
  expect(std::string(5000, '(') + "1" + std::string(5000, ')'), kInapplicable, {"too long"});
  for (const std::string program :
       {"z := 0.5", "FA += 1", "FA > 0; FA", "var a[2]; FA", "if (FA > 0) { 1 }"})
    expect(program, kInapplicable, {"not assign"});
  expect("fa", invalid, {"--where leaves no cell (2 are left out)"});
}

/// An array called as what the tensors and places give.
TEST(CellsWhere, AmbiguousNamesAreRefused) {
  ReadOptions options;
  options.tensor = "stress";
  for (const std::string name : {"magnitude", "x", "mode"})
    for (const bool on_points : {false, true}) {
      TextVtu text = cells_with_arrays();
      (on_points ? text.point_data : text.cell_data) +=
          TextVtu::array(name, 1, on_points ? "1 2 3 4 5" : "1 2");
      const auto file = put("named.vtu", text.str());
      options.where = name + " > 0";
      expect_error(file, kInapplicable, {"`" + name + "`", "rename"}, options);
      options.where = "region > 0";
      EXPECT_EQ(read_mesh(file, options).mesh.tets.size(), 2u);
    }
}

TEST(CellsWhere, CountsWhatIsLeftOutAndChangesNothingElse) {
  const auto file = put("a.vtu", cells_with_arrays().str());
  ReadOptions options;
  options.tensor = "stress";
  const ReadResult whole = read_mesh(file, options);
  options.where = "region < 8";
  const ReadResult part = read_mesh(file, options);
  EXPECT_EQ(whole.report.cells_left_out, 0u);
  EXPECT_EQ(part.report.cells_left_out, 1u);
  EXPECT_EQ(part.mesh.points, whole.mesh.points);
  EXPECT_EQ(part.mesh.tensors, whole.mesh.tensors);
  EXPECT_EQ(part.mesh.tets.size(), 1u);
  EXPECT_EQ(part.mesh.tets[0], whole.mesh.tets[0]);
  EXPECT_TRUE(std::any_of(
      part.report.notes.begin(), part.report.notes.end(),
      [](const std::string& note) { return note == "1 cell left out, where not: region < 8"; }));
  options.where = "";
  EXPECT_EQ(options.making_others(), nullptr);
  options.where = "1";
  EXPECT_STREQ(options.making_others(), "--where");
}

TEST(CellsWhere, TensorsOnCellsGiveTheirQuantitiesAndMeansAreOfAllCells) {
  TextVtu text = cells_with_arrays();
  text.point_data = "";
  text.cell_data = TextVtu::array("S", 6, "1 2 3 0 0 0  5 6 7 0 0 4");
  const auto file = put("a.vtu", text.str());
  ReadOptions options;
  options.cell_to_point = true;
  const ReadResult whole = read_mesh(file, options);
  options.where = "magnitude > 6";
  const ReadResult part = read_mesh(file, options);
  EXPECT_EQ(part.mesh.cell_ids, std::vector<std::int64_t>{1});
  EXPECT_EQ(part.mesh.tensors, whole.mesh.tensors);
}

TEST(CellsWhere, AgreesWithTheModeOfEachVertex) {
  const TetMesh mesh = cube_field(3);
  const auto file = temporary("cube.vtu");
  vtk_write_vtu(mesh, file, {});
  ReadOptions options;
  const ReadResult whole = read_mesh(file, options);
  options.where = "mode > 0.1";
  std::vector<std::int64_t> expected;
  for (std::size_t t = 0; t < whole.mesh.tets.size(); ++t) {
    const auto& tet = whole.mesh.tets[t];
    if (std::all_of(tet.begin(), tet.end(), [&](TetMesh::Index v) {
          return mode(deviator(whole.mesh.tensors[static_cast<std::size_t>(v)])) > 0.1;
        }))
      expected.push_back(whole.mesh.cell_ids[t]);
  }
  Compared compared("cells taken and left out", 2);
  compared.count(!expected.empty());
  compared.count(expected.size() < whole.mesh.tets.size());
  EXPECT_EQ(read_mesh(file, options).mesh.cell_ids, expected);
}

}  // namespace
}  // namespace tensortopo::test
