// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Tensors that are isotropic but for rounding, and components that are no numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "field_files.hpp"

namespace tensortopo::test {
namespace {



/// Two tetrahedra at a face; the tensor of the third vertex of that is given.
TextVtu field_with(const std::string& tensor) {
  TextVtu file;
  file.points = "5", file.cells = "2";
  file.coordinates = "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1";
  file.connectivity = "0 1 2 3 1 2 3 4", file.offsets = "4 8", file.types = "10 10";
  file.point_data = TextVtu::array("stress", 6, "1 2 3 4 5 6 6 5 4 3 2 1 1 0 0 0 0 1 1e-10 1 1 0 0 0 " + tensor);
  return file;
}

bool has_note(const ReadResult& read, const std::string& words) {
  return std::any_of(read.report.notes.begin(), read.report.notes.end(),
                     [&](const std::string& note) { return note.find(words) != note.npos; });
}

TEST(SmallTensors, AreSaidAndTakenAsZeroOnDemand) {
  const auto file = put("small.vtu", field_with("7 7 7.00000000000001 1e-14 0 -3e-15").str());
  const ReadResult read = read_mesh(file);
  EXPECT_TRUE(has_note(read, "1 vertex has a deviator of less than 1e-9 of a neighbour's (first: 4)"));
  EXPECT_TRUE(has_note(read, "--zero-below 7e-09"));
  ReadOptions options;
  options.zero_below = 1e-8;
  const ReadResult rounded = read_mesh(file, options);
  EXPECT_FALSE(has_note(rounded, "neighbour"));
  EXPECT_TRUE(has_note(rounded, "2 tensors changed by --zero-below 1e-08"));
  EXPECT_EQ(rounded.report.tensors_with_zeros, 2u);
  const auto& t = rounded.mesh.tensors[4];
  EXPECT_TRUE(t.xx == t.yy && t.yy == t.zz && t.xy == 0 && t.yz == 0 && t.xz == 0);
  EXPECT_NEAR(t.xx, 7, 1e-13);
  EXPECT_EQ(rounded.mesh.tensors[3].xx, 0);
  EXPECT_EQ(rounded.mesh.tensors[0].xx, 1);
  EXPECT_STREQ(options.making_others(), "--zero-below");
  EXPECT_FALSE(has_note(read_mesh(put("zero.vtu", field_with("0 0 0 0 0 0").str())), "neighbour"));
}

TEST(NotFinite, CountsWhereCellsAreTaken) {
  const auto file = put("nan.vtu", field_with("nan 0 0 0 0 nan").str());
  expect_error(file, invalid, {"not a number", "point 4", "1 more component", "--where"});
  ReadOptions options;
  options.where = "x + y + z < 2";
  const ReadResult read = read_mesh(file, options);
  EXPECT_EQ(read.mesh.tets.size(), 1u);
  EXPECT_EQ(read.mesh.tensors[4].xz, 0);
  options.where = "x + y + z < 4";
  expect_error(file, invalid, {"no finite number at vertex 4", "that --where takes"}, options);
}

}  // namespace
}  // namespace tensortopo::test
