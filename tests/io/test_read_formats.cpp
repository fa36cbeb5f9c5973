// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "field_files.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::test {
namespace {

using Mode = VtkStyle::Mode;
using Compressor = VtkStyle::Compressor;

/// VTK's text writers round to fewer digits: make numbers that survive them.
TetMesh rounded(TetMesh mesh) {
  const auto round = [](double x) { return static_cast<double>(static_cast<int>(x * 256)) / 256; };
  for (auto& p : mesh.points) p = {round(p.x), round(p.y), round(p.z)};
  for (auto& t : mesh.tensors)
    t = {round(t.xx), round(t.yy), round(t.zz), round(t.xy), round(t.yz), round(t.xz)};
  return mesh;
}

class ReadVtu : public testing::TestWithParam<std::tuple<Mode, Compressor, bool, bool>> {};

TEST_P(ReadVtu, TakesWhatVtkWrites) {
  const auto [mode, compressor, wide, big] = GetParam();
  const TetMesh field = rounded(cube_field(4));
  VtkStyle style{mode, compressor, wide, big, 1000};
  for (const int components : {6, 9}) {
    std::string name = "field" + std::to_string(components);
    for (char c : std::string("/")) std::erase(name, c);
    const auto file = temporary(name + std::to_string(static_cast<int>(mode)) +
                                std::to_string(static_cast<int>(compressor)) +
                                std::to_string(wide) + std::to_string(big) + ".vtu");
    vtk_write_vtu(field, file, style, components);
    const ReadResult result = read_mesh(file);
    expect_same_field(result.mesh, field);
    EXPECT_EQ(result.report.tensor_name, "the stress");
    EXPECT_EQ(result.report.skipped_cells_2d_1d, 1u);
    ASSERT_FALSE(result.mesh.cell_ids.empty());
    EXPECT_EQ(result.mesh.cell_ids.front(), 1);  // the triangle was cell 0
    EXPECT_EQ(result.mesh.cell_ids.back(), static_cast<std::int64_t>(field.tets.size()));
    EXPECT_EQ(result.report.reoriented_cells, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(AllStyles, ReadVtu,
                         testing::Combine(testing::Values(Mode::ascii, Mode::binary,
                                                          Mode::appended_base64,
                                                          Mode::appended_raw),
                                          testing::Values(Compressor::none, Compressor::zlib,
                                                          Compressor::lz4, Compressor::lzma),
                                          testing::Bool(), testing::Bool()));

TEST(ReadVtuExactly, Float32IsWidened) {
  TetMesh field = cube_field(2);
  const auto file = temporary("single.vtu");
  vtk_write_vtu(field, file, {}, 6, true);
  const auto single = [](double x) {
    const volatile float rounded = static_cast<float>(x);  // GCC 12 at -O2 drops the rounding else
    return static_cast<double>(rounded);
  };
  for (auto& p : field.points) p = {single(p.x), single(p.y), single(p.z)};
  for (auto& t : field.tensors)
    t = {single(t.xx), single(t.yy), single(t.zz), single(t.xy), single(t.yz), single(t.xz)};
  expect_same_field(read_mesh(file).mesh, field);
}

TEST(ReadVtuExactly, TextIsRoundedToTheTypeThatItIsOf) {
  TextVtu text;
  text.point_data = TextVtu::array(
      "stress", 6, "0.1 0 0 0 0 0 1e-50 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 0", "Float32");
  const auto mesh = read_mesh(put("single.vtu", text.str())).mesh;
  EXPECT_EQ(mesh.tensors[0].xx, static_cast<double>(0.1f));
  EXPECT_EQ(mesh.tensors[1].xx, 0.0);
}

TEST(ReadVtuExactly, IntegersAreTakenAndThoseBeyondDoubleRefused) {
  TextVtu text;
  const auto with = [&](const std::string& x) {
    text.point_data =
        TextVtu::array("stress", 6, x + " -2 3 4 5 6 1 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 0", "Int64");
    return put("integers.vtu", text.str());
  };
  EXPECT_EQ(read_mesh(with("9007199254740992")).mesh.tensors[0],
            (SymmetricTensor<double>{9007199254740992.0, -2, 3, 4, 5, 6}));
  expect_error(with("9007199254740993"), IoError::Kind::invalid, {"9007199254740993", "stress"});
  expect_error(with("9223372036854775807"), IoError::Kind::invalid, {"9223372036854775807"});
  expect_error(with("9223372036854775808"), IoError::Kind::invalid, {"out of range"});
}

TEST(ReadVtuExactly, ExtremeMagnitudesSurvive) {
  TextVtu text;
  text.point_data =
      TextVtu::array("stress", 6,
                     "1e300 -1e-300 4.9406564584124654e-324 -0.0 +2 2.2250738585072009e-308 "
                     "1.7976931348623157e308 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 0");
  const TetMesh mesh = read_mesh(put("extreme.vtu", text.str())).mesh;
  EXPECT_EQ(mesh.tensors[0],
            (SymmetricTensor<double>{1e300, -1e-300, 0x1p-1074, 0, 2, 2.2250738585072009e-308}));
  EXPECT_TRUE(std::signbit(mesh.tensors[0].xy));
  EXPECT_EQ(mesh.tensors[1].xx, 0x1.fffffffffffffp1023);
}

TEST(ReadVtuExactly, WhatWriteMeshWrites) {
  TetMesh field = cube_field(5);
  field.tensors[0] = {1e300, -1e-300, 0x1p-1074, -0.0, 0.1, 1.0 / 3};
  const auto file = temporary("field.vtu");
  write_mesh(field, file, "S & <T>");
  const ReadResult result = read_mesh(file);
  expect_same_field(result.mesh, field);
  EXPECT_EQ(result.mesh.cell_ids, field.cell_ids);
  EXPECT_EQ(result.report.tensor_name, "S & <T>");
  ASSERT_EQ(result.report.notes.size(), 1u);
  EXPECT_NE(result.report.notes[0].find("less than 1e-9 of a neighbour's"), std::string::npos);
  EXPECT_TRUE(validate(result.mesh).empty());
}

class ReadLegacy : public testing::TestWithParam<std::tuple<bool, bool, int>> {};

TEST_P(ReadLegacy, TakesWhatVtkWrites) {
  const auto [binary, version_5, components] = GetParam();
  const TetMesh field = rounded(cube_field(3));
  const auto file = temporary(std::string("field") + (binary ? "b" : "a") +
                              (version_5 ? "5" : "4") + std::to_string(components) + ".vtk");
  vtk_write_legacy(field, file, binary, version_5, components);
  const ReadResult result = read_mesh(file);
  expect_same_field(result.mesh, field);
  EXPECT_EQ(result.report.tensor_name, "the stress");
  EXPECT_EQ(result.mesh.cell_ids.front(), 1);
}

INSTANTIATE_TEST_SUITE_P(AllStyles, ReadLegacy,
                         testing::Combine(testing::Bool(), testing::Bool(), testing::Values(6, 9)));

TEST(ReadLegacyText, KnowsEveryKindOfAttribute) {
  const auto file = put(
      "field.vtk",
      text_legacy(
          "FIELD FieldData 1\nTIME 1 1 double\n0.5\n"
          "CELL_DATA 1\nSCALARS part int\nLOOKUP_TABLE default\n3\n"
          "POINT_DATA 4\nLOOKUP_TABLE colors 2\n0 0 0 1 1 1 1 1\n"
          "SCALARS t float 2\nLOOKUP_TABLE colors\n1 2 3 4 5 6 7 8\nSCALARS flag bit\nLOOKUP_TABLE "
          "default\n1 0 1 0\n"
          "COLOR_SCALARS c 3\n0 0 0 0 0 0 0 0 0 1 1 1\nVECTORS u double\n1 2 3 1 2 3 1 2 3 1 2 3\n"
          "NORMALS n float\n1 0 0 1 0 0 1 0 0 1 0 0\nTEXTURE_COORDINATES uv 2 float\n0 0 0 0 0 0 0 "
          "0\n"
          "GLOBAL_IDS id vtkIdType\n0 1 2 3\n"
          "tensors6 my%20stress float\n1 2 3 4 5 6\n1 2 3 4 5 7\n1 2 3 4 5 8\n1 2 3 4 5 9\n"
          "METADATA\nCOMPONENT_NAMES\nXX\nYY\nZZ\nXY\nYZ\nXZ\n\n"));
  const ReadResult result = read_mesh(file);
  EXPECT_EQ(result.report.tensor_name, "my stress");
  EXPECT_EQ(result.mesh.tensors[3], (SymmetricTensor<double>{1, 2, 3, 4, 5, 9}));
}

TEST(ReadLegacyText, NotesThatItsLastNumberMayBeCutOff) {
  const auto notes_of = [](const std::string& end) {
    return read_mesh(put("cut.vtk", text_legacy("POINT_DATA 4\nTENSORS6 t double\n1 2 3 4 5 6 "
                                                "1 2 3 4 5 7 1 2 3 4 5 8 1 2 3 4 5 1" +
                                                end)))
        .report.notes;
  };
  for (const std::string end : {"\n", "234.5\n", " ", "\r\n"}) EXPECT_TRUE(notes_of(end).empty());
  for (const std::string end : {"", "2", "234."}) {
    const auto notes = notes_of(end);
    ASSERT_EQ(notes.size(), 1u) << end;
    EXPECT_NE(notes[0].find("cut off"), std::string::npos) << notes[0];
  }
}

TEST(ReadMesh, SumsTheBytesOfTheFile) {
  const auto one = put("a.vtu", TextVtu{}.str()), two = put("b.vtu", TextVtu{}.str());
  const auto other = put("c.vtu", TextVtu{}.str() + " ");
  EXPECT_EQ(read_mesh(one).sha256, read_mesh(two).sha256);
  EXPECT_NE(read_mesh(one).sha256, read_mesh(other).sha256);
  EXPECT_EQ(read_mesh(one).sha256.size(), 64u);
}

TEST(ReadMesh, TheSumIsSha256) {
  const auto file =
      put("field.vtk",
          text_legacy(
              "POINT_DATA 4\nTENSORS6 s int\n1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6\n"));
  EXPECT_EQ(read_mesh(file).sha256,
            "833d5018fc599e96a6b4831ebc18ecf392781254cb4fb57e442bb7058d22dc90");
}

TEST(ReadMesh, SameBytesGiveTheSameMesh) {
  const auto file = temporary("field.vtu");
  write_mesh(cube_field(3), file);
  const auto one = read_mesh(file), two = read_mesh(file);
  expect_same_field(one.mesh, two.mesh);
  EXPECT_EQ(one.sha256, two.sha256);
}

}  // namespace
}  // namespace tensortopo::test
