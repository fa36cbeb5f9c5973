// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Collections (.pvd).

#include <gtest/gtest.h>

#include <string>

#include "field_files.hpp"
#include "tensortopo/io/field_steps.hpp"

namespace tensortopo::test {
namespace {

std::string data_set(const std::string& time, const std::string& file) {
  return "<DataSet timestep=\"" + time + "\" part=\"0\" file=\"" + file + "\"/>\n";
}

std::filesystem::path collection(const std::string& sets) {
  return put("a.pvd", "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">"
                      "<Collection>\n" + sets + "</Collection></VTKFile>\n");
}

TEST(ReadCollection, EachTimeIsAStepAndItsPartsAreOneField) {
  TextVtu text;
  put("0.vtu", text.str());
  text.point_data = TextVtu::array("stress", 6, "2 2 3 4 5 6  1 2 3 4 5 7  1 2 3 4 5 8  1 2 3 4 5 9");
  put("1.vtu", text.str());
  text.coordinates = "0 0 0  0 1 0  1 0 0  0 0 -1";
  text.point_data = TextVtu::array("stress", 6, "2 2 3 4 5 6  1 2 3 4 5 8  1 2 3 4 5 7  1 2 3 4 5 9");
  put("1b.vtu", text.str());
  const auto file = collection(data_set("0.5", "0.vtu") + data_set("2", "1.vtu") +
                               data_set("2", "1b.vtu"));
  EXPECT_EQ(field_steps(file), (std::vector<std::string>{"time 0.5", "time 2"}));
  const auto last = read_mesh(file);
  EXPECT_EQ(last.mesh.tets.size(), 2u);
  EXPECT_EQ(last.mesh.points.size(), 5u);
  EXPECT_EQ(last.mesh.tensors[0].xx, 2);
  ReadOptions options;
  options.step = 1;
  const auto first = read_mesh(file, options);
  EXPECT_EQ(first.mesh.tets.size(), 1u);
  EXPECT_EQ(first.mesh.tensors[0].xx, 1);
  EXPECT_NE(first.sha256, last.sha256);
}

TEST(ReadCollectionRefuses, WhatIsNoSeriesOfFields) {
  expect_error(collection(""), invalid, {"names no data sets"});
  expect_error(collection("<DataSet timestep=\"0\"/>"), invalid, {"names no file", "data set 0"});
  expect_error(collection(data_set("x", "0.vtu")), invalid, {"\"x\" is not a number"});
  expect_error(collection(data_set("0", "a.pvd")), invalid, {"steps of its own (a.pvd)"});
  EXPECT_EQ(error_of(collection(data_set("0", "nothing.vtu"))).kind(), IoError::Kind::unreadable);
  expect_error(put("b.pvd", "<VTKFile type=\"PolyData\"/>"), invalid, {"PolyData"});
  EXPECT_EQ(error_of(collection(data_set("0", "surface.stl"))).kind(), invalid);
}

TEST(FieldSteps, AreOfFormatsThatHaveThem) {
  EXPECT_EQ(field_steps(std::filesystem::path(TENSORTOPO_EXAMPLES) / "formats" / "plate.frd"),
            (std::vector<std::string>{"number 1, value 1.000000000", "number 2, value 2.000000000"}));
  EXPECT_THROW(field_steps(put("a.vtu", TextVtu().str())), IoError);
  ReadOptions options;
  options.step = 1;
  expect_error(put("a.vtu", TextVtu().str()), IoError::Kind::inapplicable, {"--step"}, options);
}

}  // namespace
}  // namespace tensortopo::test
