// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "field_files.hpp"

namespace tensortopo::test {
namespace {

constexpr auto unreadable = IoError::Kind::unreadable;

IoError::Kind kind_of_nothing() { return error_of(temporary("nothing.vtu")).kind(); }

TEST(ReadRefuses, AMissingFileAFolderAndAnUnknownExtension) {
  EXPECT_EQ(kind_of_nothing(), unreadable);
  expect_error(temporary("nothing.vtu"), unreadable, {"no such file"});
  expect_error(temporary("nothing.vtk"), unreadable, {"no such file"});
  std::filesystem::create_directories(temporary("folder.vtu"));
  expect_error(temporary("folder.vtu"), unreadable, {"not a regular file"});
  expect_error(put("field.stl", "solid"), invalid, {".stl", ".vtu, .pvtu, .vtk"});
}

TEST(ReadRefuses, EmptyAndForeignFiles) {
  expect_error(put("empty.vtu", ""), invalid, {});
  expect_error(put("empty.vtk", ""), invalid, {"not a legacy VTK file"});
  expect_error(put("text.vtu", "hello"), invalid, {});
  expect_error(put("text.vtk", "hello"), invalid, {"line 1"});
  expect_error(put("other.vtu", "<a/>"), invalid, {"VTKFile"});
  expect_error(put("surface.vtu", R"(<VTKFile type="PolyData"/>)"), invalid, {"PolyData"});
  expect_error(put("no-piece.vtu", R"(<VTKFile type="UnstructuredGrid"/>)"), invalid, {"no grid"});
  expect_error(put("surface.vtk", "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n"),
               invalid, {"POLYDATA", "line 4"});
}

/// VTK refuses such files, or reads other numbers.
TEST(ReadRefuses, MoreThanOneElementAndCommentsInArrays) {
  const std::string text = TextVtu{}.str();
  const auto put_with = [&](const std::string& before, const std::string& more) {
    std::string changed = text;
    const std::size_t at = before.empty() ? text.size() : changed.find(before);
    EXPECT_NE(at, std::string::npos);
    return put("more.vtu", changed.insert(at, more));
  };
  expect_error(put_with("", "more"), invalid, {"not well-formed", "VTKFile"});
  expect_error(put_with("", "<a/>"), invalid, {"not well-formed"});
  expect_error(put_with("<VTKFile", "more"), invalid, {"not well-formed"});
  expect_error(put_with("</DataArray>", "<!-- -->"), invalid, {"comment"});
  for (const std::string before : {"", "<VTKFile", "<Points>", "<DataArray"})
    EXPECT_EQ(read_mesh(put_with(before, "<!-- a comment -->\n")).mesh.tensors,
              read_mesh(put("a.vtu", text)).mesh.tensors);
}

TEST(ReadRefuses, NoTensors) {
  TextVtu text;
  text.point_data = TextVtu::array("u", 3, "0 0 0 0 0 0 0 0 0 0 0 0");
  text.cell_data = TextVtu::array("part", 1, "1");
  expect_error(put("a.vtu", text.str()), invalid, {"6 or 9 components", "`u` (3)", "`part` (1)"});
  text.point_data = text.cell_data = "";
  expect_error(put("b.vtu", text.str()), invalid, {"on points none"});
  expect_error(put("a.vtk", text_legacy("")), invalid, {"on points none"});
}

TEST(ReadRefuses, SeveralCandidatesUnlessOneIsNamed) {
  TextVtu text;
  text.point_data += TextVtu::array(
      "strain", 9, "1 0 0 0 2 0 0 0 3  1 0 0 0 2 0 0 0 3  1 0 0 0 2 0 0 0 3  1 0 0 0 2 0 0 0 3");
  const auto file = put("two.vtu", text.str());
  expect_error(file, invalid, {"`stress` (6)", "`strain` (9)", "--tensor"});
  ReadOptions options;
  options.tensor = "strain";
  EXPECT_EQ(read_mesh(file, options).mesh.tensors[1], (SymmetricTensor<double>{1, 2, 3, 0, 0, 0}));
  options.tensor = "strian";
  expect_error(file, invalid, {"no array `strian`", "`stress` (6)"}, options);
}

TEST(ReadNotes, ThatCellsHaveTensorsAsWell) {
  TextVtu text;
  EXPECT_TRUE(read_mesh(put("one.vtu", text.str())).report.notes.empty());
  for (const std::string name : {"strain", "stress"}) {
    text.cell_data = TextVtu::array(name, 6, "1 2 3 4 5 6");
    const auto file = put("both.vtu", text.str());
    for (const std::string asked : {"", "stress"})
      for (const bool of_cells : {false, true}) {
        ReadOptions options;
        options.tensor = asked, options.cell_to_point = of_cells;
        const ReadReport report = read_mesh(file, options).report;
        const bool are_others = asked.empty() || name == asked;
        EXPECT_EQ(std::count_if(report.notes.begin(), report.notes.end(),
                                [](const std::string& n) {
                                  return n.find("as well") != std::string::npos;
                                }),
                  are_others ? 1 : 0)
            << name << ' ' << asked << ' ' << of_cells;
      }
  }
}

TEST(ReadRefuses, TwoArraysOfOneName) {
  TextVtu text;
  text.point_data += text.point_data;
  ReadOptions options;
  options.tensor = "stress";
  expect_error(put("twice.vtu", text.str()), invalid, {"several arrays named `stress`"}, options);
}

TEST(ReadRefuses, AWrongNumberOfComponents) {
  TextVtu text;
  text.point_data = TextVtu::array("stress", 4, "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0");
  ReadOptions options;
  options.tensor = "stress";
  expect_error(put("four.vtu", text.str()), invalid, {"`stress` has 4 components"}, options);
}

TEST(ReadRefuses, AnArrayOfTheWrongLength) {
  TextVtu text;
  for (const std::string numbers :
       {"1 2 3", "", "1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 7"}) {
    text.point_data = TextVtu::array("stress", 6, numbers);
    expect_error(put("array.vtu", text.str()), invalid, {"stress", "24"});
  }
  text = {};
  text.coordinates = "0 0 0 1 0 0";
  expect_error(put("points.vtu", text.str()), invalid, {"Points", "12"});
  text = {};
  text.offsets = "4 8";
  expect_error(put("offsets.vtu", text.str()), invalid, {"offsets"});
  text = {};
  text.connectivity = "0 1 2";
  expect_error(put("connectivity.vtu", text.str()), invalid, {"connectivity", "4"});
  text = {};
  text.types = "";
  expect_error(put("types.vtu", text.str()), invalid, {"types"});
  expect_error(
      put("a.vtk",
          text_legacy(
              "POINT_DATA 4\nFIELD f 1\ns 6 3 double\n1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6\n")),
      invalid, {"`s` has 3 tuples where 4 belong", "line"});
  expect_error(put("b.vtk", text_legacy("POINT_DATA 3\n")), invalid, {"3 entries where 4 belong"});
}

TEST(ReadRefuses, NumbersThatAreNotFinite) {
  TextVtu text;
  for (const auto& [bad, said] :
       {std::pair{"nan", "not a number"}, std::pair{"-inf", "infinite"}}) {
    text.point_data = TextVtu::array(
        "stress", 6, std::string("1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 ") + bad + " 5 6 1 2 3 4 5 6");
    expect_error(put("tensor.vtu", text.str()), invalid, {said, "point 2 of `stress`"});
    expect_error(
        put("tensor.vtk",
            text_legacy(
                std::string("POINT_DATA 4\nTENSORS6 s double\n1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 ") +
                bad + " 5 6 1 2 3 4 5 6\n")),
        invalid, {said, "point 2 of `s`"});
  }
  text = {};
  text.coordinates = "0 0 0 1 nan 0 0 1 0 0 0 1";
  expect_error(put("point.vtu", text.str()), invalid, {"not finite", "point 1"});
}

TEST(ReadRefuses, TextThatIsNoNumberOrTooLarge) {
  TextVtu text;
  for (const std::string bad : {"1e400", "-1e400", "x", "1.0.0", "1,5", "0x10", "--1", "1e"}) {
    text.point_data =
        TextVtu::array("stress", 6, "1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 " + bad);
    expect_error(put("number.vtu", text.str()), invalid, {"stress", "\"" + bad + "\""});
  }
  text.point_data =
      TextVtu::array("stress", 6, "1e39 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6", "Float32");
  expect_error(put("float.vtu", text.str()), invalid, {"1e39"});
  text = {};
  text.connectivity = "0 1 2 3.5";
  expect_error(put("corner.vtu", text.str()), invalid, {"connectivity", "3.5"});
}

TEST(ReadRefuses, CornersOutOfRange) {
  TextVtu text;
  for (const std::string bad : {"4", "-1", "2147483648", "9223372036854775807"}) {
    text.connectivity = "0 1 2 " + bad;
    expect_error(put("corner.vtu", text.str()), invalid, {"names point " + bad, "cell 0"});
  }
  auto legacy = text_legacy("");
  legacy.replace(legacy.find("4 0 1 2 3"), 9, "4 0 1 2 9");
  expect_error(put("corner.vtk", legacy), invalid, {"names point 9", "cell 0"});
}

TEST(ReadRefuses, OffsetsThatDoNotRise) {
  TextVtu text;
  text.cells = "2";
  text.types = "10 10";
  text.connectivity = "0 1 2 3";
  for (const std::string offsets : {"8 4", "-4 4"}) {
    text.offsets = offsets;
    expect_error(put("offsets.vtu", text.str()), invalid, {"offsets", "cell 0"});
  }
  text.offsets = "4 -4";
  expect_error(put("negative.vtu", text.str()), invalid, {"negative"});
  text.offsets = "4 9223372036854775807";
  expect_error(put("huge.vtu", text.str()), invalid, {});
}

TEST(ReadRefuses, ATetrahedronWithOtherThanFourCorners) {
  TextVtu text;
  text.connectivity = "0 1 2";
  text.offsets = "3";
  expect_error(put("three.vtu", text.str()), invalid, {"3 corners where 4 belong", "cell 0"});
}

TEST(ReadRefuses, HugeCounts) {
  for (const std::string count :
       {"1000000000000", "18446744073709551615", "2000000000", "99999999999999999999"}) {
    TextVtu text;
    text.points = count;
    expect_error(put("points.vtu", text.str()), invalid, {});
    text = {};
    text.cells = count;
    expect_error(put("cells.vtu", text.str()), invalid, {});
    text = {};
    text.offsets = count;
    expect_error(put("offset.vtu", text.str()), invalid, {});
    auto legacy = text_legacy("POINT_DATA 4\nTENSORS s double\n");
    for (const std::string where : {"POINTS 4", "CELLS 1", "CELL_TYPES 1", "POINT_DATA 4"}) {
      auto spoiled = legacy;
      spoiled.replace(spoiled.find(where), where.size(), where.substr(0, where.size() - 1) + count);
      expect_error(put("count.vtk", spoiled), invalid, {"line"});
      spoiled.replace(spoiled.find("ASCII"), 5, "BINARY");
      expect_error(put("count-binary.vtk", spoiled), invalid, {"byte"});
    }
    expect_error(put("field.vtk", text_legacy("POINT_DATA 4\nFIELD f " + count + "\n")), invalid,
                 {});
    expect_error(
        put("comps.vtk", text_legacy("POINT_DATA 4\nFIELD f 1\ns " + count + " 4 double\n")),
        invalid, {});
  }
  TextVtu text;
  text.points = "-4";
  expect_error(put("negative.vtu", text.str()), invalid, {"NumberOfPoints"});
}

TEST(ReadRefuses, UnknownTypesFormatsAndCompressors) {
  TextVtu text;
  text.header += R"( compressor="vtkZstdDataCompressor")";
  expect_error(put("compressor.vtu", text.str()), invalid, {"vtkZstdDataCompressor"});
  text = {};
  text.header = R"(type="UnstructuredGrid" header_type="UInt16")";
  expect_error(put("header.vtu", text.str()), invalid, {"UInt16"});
  text.header = R"(type="UnstructuredGrid" byte_order="MiddleEndian")";
  expect_error(put("order.vtu", text.str()), invalid, {"MiddleEndian"});
  text = {};
  text.point_data = TextVtu::array("stress", 6, "1", "Float16");
  expect_error(put("type.vtu", text.str()), invalid, {"Float16", "stress"});
  expect_error(put("type.vtk", text_legacy("POINT_DATA 4\nTENSORS s half\n")), invalid,
               {"half", "line"});
  expect_error(put("word.vtk", text_legacy("POINT_DATA 4\nSPINORS s double\n")), invalid,
               {"spinors"});
}

TEST(ReadRefuses, ControlCharactersInItsMessages) {
  TextVtu text;
  text.point_data = TextVtu::array("a&#10;b&#27;[31m", 5, "1");
  const std::string what = error_of(put("name.vtu", text.str())).what();
  for (const char c : what) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
}

TEST(ReadRefuses, BadGeometry) {
  TextVtu text;
  text.coordinates = "0 0 0 1 0 0 0 1 0 1 1 0";
  expect_error(put("flat.vtu", text.str()), invalid, {"flat", "cell 0"});
  text = {};
  text.connectivity = "0 1 2 2";
  expect_error(put("repeated.vtu", text.str()), invalid, {"vertex twice", "cell 0"});
  text.connectivity = "0 1 2 3 1 2 3 0";
  text.cells = "2", text.offsets = "4 8", text.types = "10 10";
  expect_error(put("copy.vtu", text.str()), invalid, {"same vertices", "cell 1", "cell 0"});
  text.points = "5", text.coordinates += " 0.1 0.1 2";
  text.point_data =
      TextVtu::array("stress", 6, "1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6");
  text.connectivity = "0 1 2 3 0 1 2 4";
  expect_error(put("overlap.vtu", text.str()), invalid, {"overlap", "face 0 1 2"});
  text.points = "6", text.coordinates += " 0.1 0.1 -2";
  text.point_data = TextVtu::array(
      "stress", 6, "1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6");
  text.connectivity += " 0 1 2 5";
  text.cells = "3", text.offsets = "4 8 12", text.types = "10 10 10";
  expect_error(put("crowd.vtu", text.str()), invalid, {"cell 2", "two others", "face 0 1 2"});
}

}  // namespace
}  // namespace tensortopo::test
