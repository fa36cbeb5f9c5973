// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "field_files.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::test {
namespace {

const std::string kFourTensors = "1 2 3 4 5 6 1 2 3 4 5 7 1 2 3 4 5 8 1 2 3 4 5 9";

/// The tetrahedron beyond the face x + y + z = 1 of the standard one: shares three points with it.
TextVtu neighbour() {
  TextVtu text;
  text.coordinates = "1 1 1  1 0 0  -0.0 1 0  0 0 1";
  text.point_data = TextVtu::array("stress", 6, "0 0 0 0 0 0 1 2 3 4 5 7 1 2 3 4 5 8 1 2 3 4 5 9");
  text.connectivity = "0 1 3 2";
  return text;
}

std::filesystem::path index_of(const std::vector<std::string>& sources) {
  std::string text = "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid GhostLevel=\"0\">\n";
  for (const auto& source : sources) text += "<Piece Source=\"" + source + "\"/>\n";
  return put("index.pvtu", text + "</PUnstructuredGrid></VTKFile>\n");
}

TEST(ReadPieces, PointsThatAgreeBecomeOne) {
  put("a.vtu", TextVtu{}.str());
  put("b.vtu", neighbour().str());
  const ReadResult result = read_mesh(index_of({"a.vtu", "b.vtu"}));
  EXPECT_EQ(result.mesh.points.size(), 5u);
  EXPECT_EQ(result.report.merged_points, 3u);
  EXPECT_EQ(result.mesh.tets, (std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {4, 1, 3, 2}}));
  EXPECT_EQ(result.mesh.cell_ids, (std::vector<std::int64_t>{0, 1}));
  EXPECT_EQ(result.mesh.tensors[4], SymmetricTensor<double>{});
  EXPECT_TRUE(validate(result.mesh).empty());
}

TEST(ReadPieces, OfOneFileAreMergedToo) {
  const std::string one = TextVtu{}.str(), two = neighbour().str();
  const auto begin = one.find("<Piece"), end = one.find("</UnstructuredGrid>");
  const std::string other = two.substr(begin, two.find("</UnstructuredGrid>") - begin);
  const auto file = put("two.vtu", one.substr(0, end) + other + one.substr(end));
  EXPECT_EQ(read_mesh(file).mesh.points.size(), 5u);
}

TEST(ReadPieces, DifferentTensorsAtOnePointAreRefused) {
  put("a.vtu", TextVtu{}.str());
  TextVtu b = neighbour();
  b.point_data = TextVtu::array("stress", 6, "0 0 0 0 0 0 1 2 3 4 5 7 1 2 3 4 5 8.5 1 2 3 4 5 9");
  const auto file = put("b.vtu", b.str());
  const auto index = index_of({"a.vtu", "b.vtu"});
  const IoError error = error_of(index);
  EXPECT_EQ(error.kind(), invalid);
  EXPECT_EQ(error.file(), file);
  EXPECT_NE(std::string(error.what()).find("another tensor than a piece before it at the same "
                                          "point (point 2) (named by " + index.string() + ")"),
            std::string::npos);
}

TEST(ReadPieces, CoincidingPointsOfOnePieceStayApartUnlessAnotherMeetsThem) {
  TextVtu crack;
  crack.points = "8", crack.cells = "2";
  crack.coordinates = "0 0 0 1 0 0 0 1 0 0 0 1  1 1 1 1 0 0 0 1 0 0 0 1";
  crack.point_data = TextVtu::array("stress", 6, kFourTensors + " " + kFourTensors);
  crack.connectivity = "0 1 2 3 4 5 7 6", crack.offsets = "4 8", crack.types = "10 10";
  put("crack.vtu", crack.str());
  TextVtu far;
  far.coordinates = "10 0 0 11 0 0 10 1 0 10 0 1";
  put("far.vtu", far.str());
  EXPECT_EQ(read_mesh(index_of({"crack.vtu", "far.vtu"})).mesh.points.size(), 12u);
  TextVtu near;
  near.coordinates = "1 0 0 5 0 0 5 1 0 5 0 1";
  near.point_data = TextVtu::array("stress", 6, "1 2 3 4 5 7 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0");
  put("near.vtu", near.str());
  const std::string what = error_of(index_of({"near.vtu", "crack.vtu"})).what();
  EXPECT_NE(what.find("coincide where pieces meet"), std::string::npos) << what;
  EXPECT_NE(std::string(error_of(index_of({"crack.vtu", "near.vtu"})).what()).find("coincide"),
            std::string::npos);
}

TEST(ReadPieces, CellTensorsAreAveragedAcrossThem) {
  TextVtu a, b = neighbour();
  a.point_data = b.point_data = "";
  a.cell_data = TextVtu::array("stress", 6, "1 1 1 1 1 1");
  b.cell_data = TextVtu::array("stress", 6, "3 3 3 3 3 3");
  put("a.vtu", a.str());
  put("b.vtu", b.str());
  ReadOptions options;
  options.cell_to_point = true;
  const auto mesh = read_mesh(index_of({"a.vtu", "b.vtu"}), options).mesh;
  EXPECT_EQ(mesh.tensors[0].xx, 1);
  EXPECT_EQ(mesh.tensors[1].xx, 2);
  EXPECT_EQ(mesh.tensors[4].xx, 3);
}

TEST(ReadPieces, TheSumIsOfAllBytes) {
  put("a.vtu", TextVtu{}.str());
  put("b.vtu", neighbour().str());
  const auto index = index_of({"a.vtu", "b.vtu"});
  const std::string before = read_mesh(index).sha256;
  EXPECT_EQ(read_mesh(index).sha256, before);
  put("b.vtu", neighbour().str() + "\n");
  EXPECT_NE(read_mesh(index).sha256, before);
}

TEST(ReadPieces, MissingOrUnlikePiecesAreRefused) {
  put("a.vtu", TextVtu{}.str());
  const auto index = index_of({"a.vtu", "gone.vtu"});
  const IoError gone = error_of(index);
  EXPECT_EQ(gone.kind(), IoError::Kind::unreadable);
  EXPECT_EQ(gone.file(), temporary("gone.vtu"));
  EXPECT_NE(std::string(gone.what()).find("(named by " + index.string() + ")"), std::string::npos);
  TextVtu b = neighbour();
  b.point_data = TextVtu::array("strain", 6, kFourTensors);
  put("b.vtu", b.str());
  const IoError error = error_of(index_of({"a.vtu", "b.vtu"}));
  EXPECT_EQ(error.file(), temporary("b.vtu"));
  expect_error(index_of({}), invalid, {"names no pieces"});
  expect_error(index_of({""}), invalid, {"names no file"});
  EXPECT_EQ(error_of(index_of({"index.pvtu"})).kind(), invalid);
  EXPECT_EQ(error_of(index_of({"."})).kind(), IoError::Kind::unreadable);
}

TEST(ReadPieces, EmptyOnesArePassedOver) {
  TextVtu nothing;
  nothing.points = nothing.cells = "0";
  nothing.coordinates = nothing.connectivity = nothing.offsets = nothing.types =
      nothing.point_data = "";
  put("nothing.vtu", nothing.str());
  put("a.vtu", TextVtu{}.str());
  EXPECT_EQ(read_mesh(index_of({"nothing.vtu", "a.vtu"})).mesh.tets.size(), 1u);
  EXPECT_EQ(error_of(index_of({"nothing.vtu"})).kind(), invalid);
}

}  // namespace
}  // namespace tensortopo::test
