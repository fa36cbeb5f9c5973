// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "field_files.hpp"

namespace tensortopo::test {
namespace {

std::string four_times(const std::string& numbers) {
  return numbers + "\n" + numbers + "\n" + numbers + "\n" + numbers;
}

std::filesystem::path with_nine(const std::string& numbers) {
  TextVtu text;
  text.point_data = TextVtu::array("stress", 9, four_times(numbers));
  return put("nine.vtu", text.str());
}

TEST(ReadTensors, SixComponentsInEachOrder) {
  TextVtu text;
  text.point_data = TextVtu::array("stress", 6, four_times("1 2 3 4 5 6"));
  const auto file = put("six.vtu", text.str());
  ReadOptions options;
  EXPECT_EQ(read_mesh(file, options).mesh.tensors[0], (SymmetricTensor<double>{1, 2, 3, 4, 5, 6}));
  options.components = ComponentOrder::vtk;
  EXPECT_EQ(read_mesh(file, options).mesh.tensors[0], (SymmetricTensor<double>{1, 2, 3, 4, 5, 6}));
  options.components = ComponentOrder::voigt;  // YZ XZ XY
  EXPECT_EQ(read_mesh(file, options).mesh.tensors[0], (SymmetricTensor<double>{1, 2, 3, 6, 4, 5}));
  options.components = ComponentOrder::abaqus;  // XY XZ YZ
  EXPECT_EQ(read_mesh(file, options).mesh.tensors[0], (SymmetricTensor<double>{1, 2, 3, 4, 6, 5}));
  options.components = ComponentOrder::nifti;  // XX XY YY XZ YZ ZZ
  EXPECT_EQ(read_mesh(file, options).mesh.tensors[0], (SymmetricTensor<double>{1, 3, 6, 2, 5, 4}));
  options.components = ComponentOrder::fsl;  // XX XY XZ YY YZ ZZ
  EXPECT_EQ(read_mesh(file, options).mesh.tensors[0], (SymmetricTensor<double>{1, 4, 6, 2, 5, 3}));
}

TEST(ReadTensors, AnOrderOfSixIsNoneOfNine) {
  for (const auto order : {ComponentOrder::vtk, ComponentOrder::voigt, ComponentOrder::abaqus}) {
    ReadOptions options;
    options.components = order;
    expect_error(with_nine("1 4 6 4 2 5 6 5 3"), IoError::Kind::inapplicable,
                 {"--components", "stress", "9"}, options);
  }
}

TEST(ReadTensors, NineComponentsAreRowMajor) {
  const auto result = read_mesh(with_nine("1 4 6 4 2 5 6 5 3"));
  EXPECT_EQ(result.mesh.tensors[3], (SymmetricTensor<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(result.report.symmetrized_tensors, 0u);
}

TEST(ReadTensors, AsymmetryIsRefusedUnlessSymmetrized) {
  for (const std::string numbers : {"1 4 6 5 2 5 6 5 3", "1 4 6 4 2 5 6.1 5 3", "1 4 6 4 2 0 6 5 3",
                                    "0 1e300 0 -1e300 0 0 0 0 0", "0 1e-320 0 0 0 0 0 0 0"}) {
    expect_error(with_nine(numbers), invalid, {"not symmetric", "point 0", "--symmetrize"});
    ReadOptions options;
    options.symmetrize = true;
    EXPECT_EQ(read_mesh(with_nine(numbers), options).report.symmetrized_tensors, 4u);
  }
  ReadOptions options;
  options.symmetrize = true;
  EXPECT_EQ(read_mesh(with_nine("1 4 6 5 2 5 7 6 3"), options).mesh.tensors[0],
            (SymmetricTensor<double>{1, 2, 3, 4.5, 5.5, 6.5}));
  EXPECT_EQ(read_mesh(with_nine("0 1.7e308 0 1.6e308 0 0 0 0 0"), options).mesh.tensors[0].xy,
            1.7e308 / 2 + 1.6e308 / 2);
}

TEST(ReadTensors, SlightAsymmetryIsAveragedAndCounted) {
  const auto result = read_mesh(with_nine("1 4 6 4.000000001 2 5 6 5 3"));
  EXPECT_EQ(result.mesh.tensors[0].xy, 2.0 + 4.000000001 / 2);
  EXPECT_EQ(result.report.symmetrized_tensors, 4u);
  expect_error(with_nine("1 4 6 4.00000002 2 5 6 5 3"), invalid, {"not symmetric"});
}

TEST(ReadTensors, OnCellsNeedTheFlag) {
  TextVtu text;
  text.points = "6";
  text.coordinates += " 1 1 1  9 9 9";
  text.cells = "3";
  text.connectivity = "0 1 2 3 0 1 4 1 3 2";
  text.offsets = "4 6 10", text.types = "10 3 10";
  text.point_data = "";
  text.cell_data = TextVtu::array("stress", 6, "1 2 3 4 5 6  100 100 100 100 100 100  3 4 5 6 7 8");
  const auto file = put("cells.vtu", text.str());
  expect_error(file, invalid, {"`stress` belong to cells", "--cell-to-point"});
  ReadOptions options;
  options.cell_to_point = true;
  const ReadResult result = read_mesh(file, options);
  EXPECT_EQ(result.mesh.tensors[0], (SymmetricTensor<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(result.mesh.tensors[1], (SymmetricTensor<double>{2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(result.mesh.tensors[4], (SymmetricTensor<double>{3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(result.mesh.tensors[5], (SymmetricTensor<double>{}));
  EXPECT_EQ(result.report.averaged_vertices, 5u);
  EXPECT_EQ(result.report.unreferenced_points, 1u);
  EXPECT_EQ(result.mesh.cell_ids, (std::vector<std::int64_t>{0, 2}));
  options.tensor = "stress";
  EXPECT_EQ(read_mesh(file, options).report.averaged_vertices, 5u);
}

// The option says which are meant; without it those on points are.
TEST(ReadTensors, OnCellsAreTakenIfAskedForThoughPointsHaveSome) {
  for (const std::string name : {"stress", "strain"}) {
    TextVtu text;
    text.cell_data = TextVtu::array(name, 6, "1 2 3 4 5 7");
    const auto file = put("both.vtu", text.str());
    for (const bool is_named : {false, true}) {
      ReadOptions options;
      if (is_named) options.tensor = "stress";
      EXPECT_EQ(read_mesh(file, options).mesh.tensors[3].xz, 9);
      if (is_named) options.tensor = name;
      options.cell_to_point = true;
      EXPECT_EQ(read_mesh(file, options).mesh.tensors[3].xz, 7) << name << is_named;
    }
  }
}

TEST(ReadTensors, CellTensorsTooLargeToAverage) {
  TextVtu text;
  text.points = "5";
  text.coordinates += " 1 1 1";
  text.cells = "2", text.connectivity = "0 1 2 3 4 1 3 2", text.offsets = "4 8",
  text.types = "10 10";
  text.point_data = "";
  text.cell_data = TextVtu::array("stress", 6, "1.7e308 0 0 0 0 0 1.7e308 0 0 0 0 0");
  ReadOptions options;
  options.cell_to_point = true;
  expect_error(put("large.vtu", text.str()), invalid, {"too large to average", "point 1"}, options);
}

}  // namespace
}  // namespace tensortopo::test
