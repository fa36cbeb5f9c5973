// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "field_files.hpp"
#include "tensortopo/io/read_surface_file.hpp"
#include "tensortopo/io/read_text.hpp"
#include "write_case.hpp"

namespace tensortopo::test {
namespace {

IoError surface_error(const std::filesystem::path& file) {
  try {
    read_surface_file(file);
  } catch (const IoError& error) {
    return error;
  }
  ADD_FAILURE() << "was read: " << file;
  return {invalid, file, ""};
}

/// Expects an error of one line that names the file and holds every part.
void refuses(const std::string& name, const std::string& bytes,
             const std::vector<std::string>& parts) {
  const auto file = put(name, bytes);
  const IoError error = surface_error(file);
  const std::string what = error.what();
  EXPECT_EQ(error.kind(), invalid);
  EXPECT_EQ(what.find(file.string()), 0u) << what;
  EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  for (const auto& part : parts) EXPECT_NE(what.find(part), std::string::npos) << part << what;
}

TEST(ReadSurfaces, GiveBackWhatWasWritten) {
  const SurfaceMesh s = surface_of_two();
  const CurveMesh c = curve_of_three();
  for (const char* name : {"s.vtp", "s.ply", "s.obj", "s.off"}) {
    const bool holds_curves = std::string(name) != "s.off";
    write_surface(s, holds_curves ? c : CurveMesh{}, mesh_of_two(), temporary(name));
    const SurfaceFile read = read_surface_file(temporary(name));
    ASSERT_EQ(read.points.size(), 4u + (holds_curves ? 3 : 0)) << name;
    for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(read.points[i] == s.points[i]) << name;
    EXPECT_EQ(triangulated(read), s.triangles) << name;
    // A .ply has a line for each segment.
    EXPECT_EQ(read.lines.size(), holds_curves ? std::string(name) == "s.ply" ? 3u : 2u : 0u);
  }
  const SurfaceFile vtp = read_surface_file(temporary("s.vtp"));
  EXPECT_EQ(vtp.lines.points, (std::vector<std::int32_t>{6, 4, 5, 5, 6}));
  ASSERT_NE(vtp.find_point_data("residual"), nullptr);
  EXPECT_EQ(vtp.find_point_data("residual")->values[0], 1e-17);
  ASSERT_NE(vtp.find_cell_data("tet"), nullptr);  // two lines, then two triangles
  EXPECT_EQ(vtp.find_cell_data("tet")->values, (std::vector<double>{70, 5e9, 5e9, 70}));
  EXPECT_EQ(vtp.find_point_data("no such"), nullptr);

  SurfaceMesh flat = s;
  for (auto& p : flat.points) p = {p.x > 1e6 ? 7 : std::round(p.x), std::round(p.y), 0.5};
  write_surface(flat, mesh_of_two(), temporary("s.stl"));
  const SurfaceFile stl = read_surface_file(temporary("s.stl"));
  ASSERT_EQ(stl.points.size(), 6u);
  EXPECT_TRUE(stl.points[4] == flat.points[1]);
  EXPECT_EQ(stl.polygons.points, (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5}));
}

/// How VTK writes a .vtp.
using Style = std::tuple<VtkStyle::Mode, VtkStyle::Compressor, bool, bool>;
class ReadVtp : public testing::TestWithParam<Style> {};

TEST_P(ReadVtp, TakesWhatVtkWrites) {
  const auto [mode, compressor, wide, big] = GetParam();
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 6; ++i) points->InsertNextPoint(i * 0.1, i % 2, i / 3.0);
  data->SetPoints(points);
  vtkNew<vtkCellArray> verts, lines, polys, strips;
  verts->InsertNextCell({5});
  lines->InsertNextCell({0, 2, 4});
  polys->InsertNextCell({0, 1, 2, 3});
  polys->InsertNextCell({1, 2, 5});
  strips->InsertNextCell({0, 1, 2, 3, 4});
  data->SetVerts(verts), data->SetLines(lines), data->SetPolys(polys), data->SetStrips(strips);
  vtkNew<vtkDoubleArray> values;
  values->SetName("mode");
  for (int i = 0; i < 6; ++i) values->InsertNextValue(1.0 / (i + 1));
  data->GetPointData()->AddArray(values);
  vtkNew<vtkIntArray> ids;
  ids->SetName("tet");
  for (int i = 0; i < 5; ++i) ids->InsertNextValue(10 + i);
  data->GetCellData()->AddArray(ids);

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  if (mode == VtkStyle::Mode::ascii) writer->SetDataModeToAscii();
  if (mode == VtkStyle::Mode::binary) writer->SetDataModeToBinary();
  if (mode == VtkStyle::Mode::appended_base64 || mode == VtkStyle::Mode::appended_raw) writer->SetDataModeToAppended();
  writer->SetEncodeAppendedData(mode == VtkStyle::Mode::appended_base64);
  writer->SetCompressorType(compressor == VtkStyle::Compressor::none   ? vtkXMLWriter::NONE
                            : compressor == VtkStyle::Compressor::zlib ? vtkXMLWriter::ZLIB
                            : compressor == VtkStyle::Compressor::lz4  ? vtkXMLWriter::LZ4
                                                             : vtkXMLWriter::LZMA);
  wide ? writer->SetHeaderTypeToUInt64() : writer->SetHeaderTypeToUInt32();
  big ? writer->SetByteOrderToBigEndian() : writer->SetByteOrderToLittleEndian();
  const auto file = temporary("vtk.vtp");
  writer->SetFileName(file.c_str());
  ASSERT_EQ(writer->Write(), 1);

  const SurfaceFile read = read_surface_file(file);
  ASSERT_EQ(read.points.size(), 6u);
  for (vtkIdType i = 0; i < 6; ++i) {
    double p[3];
    data->GetPoint(i, p);
    EXPECT_TRUE(read.points[static_cast<std::size_t>(i)] == (Vector3<double>{p[0], p[1], p[2]}));
    EXPECT_EQ(read.find_point_data("mode")->values[static_cast<std::size_t>(i)],
              values->GetValue(i));
  }
  EXPECT_EQ(read.lines.points, (std::vector<std::int32_t>{0, 2, 4}));
  EXPECT_EQ(read.polygons.points,
            (std::vector<std::int32_t>{0, 1, 2, 3, 1, 2, 5, 0, 1, 2, 2, 1, 3, 2, 3, 4}));
  // Of the vertex (10) nothing is kept; the strip's triangles have its value.
  EXPECT_EQ(read.find_cell_data("tet")->values, (std::vector<double>{11, 12, 13, 14, 14, 14}));
}

INSTANTIATE_TEST_SUITE_P(
    AllStyles, ReadVtp,
    testing::Combine(testing::Values(VtkStyle::Mode::ascii, VtkStyle::Mode::binary,
                                     VtkStyle::Mode::appended_base64, VtkStyle::Mode::appended_raw),
                     testing::Values(VtkStyle::Compressor::none, VtkStyle::Compressor::zlib,
                                     VtkStyle::Compressor::lz4, VtkStyle::Compressor::lzma),
                     testing::Bool(), testing::Bool()));

std::string ply_text(const std::string& elements, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}
const std::string kVertices =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";

TEST(ReadSurfaces, RefuseWhatIsNoPly) {
  const std::string points = "0 0 0 1 0 0 0 1 0 ";
  EXPECT_EQ(read_surface_file(put("good.ply", ply_text(kVertices + kFaces, points + "3 0 1 2")))
                .polygons.size(),
            1u);
  refuses("a.ply", "", {"ends within its header"});
  refuses("a.ply", "plx\n", {"does not begin"});
  refuses("a.ply", "ply\nformat ascii 1.0\n", {"ends within its header"});
  refuses("a.ply", "ply\nformat ascii 2.0\nend_header\n", {"another version"});
  refuses("a.ply", "ply\nformat binary 1.0\nend_header\n", {"unknown format \"binary\""});
  refuses("a.ply", "ply\nelement vertex 0\nend_header\n", {"has no format"});
  refuses("a.ply", ply_text("", ""), {"no element vertex"});
  refuses("a.ply", ply_text(kFaces + kVertices, points), {"before its vertices"});
  refuses("a.ply", ply_text("element vertex -3\n", points), {"no count of its element vertex"});
  refuses("a.ply", ply_text("property float x\n", points), {"out of place"});
  refuses("a.ply", ply_text("element other 1\n" + kVertices, points), {"without properties"});
  refuses("a.ply", ply_text("element vertex 1\nproperty float x\n", points), {"property y"});
  refuses("a.ply", ply_text("element vertex 1\nproperty flot x\n", points), {"unknown type"});
  refuses("a.ply", ply_text(kVertices + kVertices, points + points), {"vertex twice"});
  refuses("a.ply", ply_text(kVertices, points + "1"), {"more than its header declares"});
  refuses("a.ply", ply_text(kVertices, "0 0 0 1 0 0 0 1"), {"ends before"});
  refuses("a.ply", ply_text(kVertices, "0 0 0 1 0 0 0 1 nan"), {"not finite", "point 2"});
  refuses("a.ply", ply_text(kVertices, "0 0 0 1 0 0 0 1 x"), {"\"x\" is not a number"});
  for (const char* list : {"3 0 1 3", "3 0 1 -1", "4 0 1 2 2147483647"})
    refuses("a.ply", ply_text(kVertices + kFaces, points + list), {"polygon names point"});
  refuses("a.ply", ply_text(kVertices + kFaces, points + "200 0 1 2"), {"ends before"});
  refuses("a.ply", ply_text(kVertices + "element face 1\nproperty list float int vertex_indices\n",
                            points + "3 0 1 2"),
          {"counts a list with fractions"});
  refuses("a.ply", ply_text(kVertices + "element face 1\nproperty list char int vertex_indices\n",
                            points + "-3 0 1 2"),
          {"list of -3"});
  refuses("a.ply", ply_text(kVertices + "element face 1\nproperty int a\n", points + "3"),
          {"no list vertex_indices"});
  for (const char* count : {"1000000000", "18446744073709551615"}) {
    refuses("a.ply", ply_text("element vertex " + std::string(count) +
                                  "\nproperty float x\nproperty float y\nproperty float z\n",
                              points),
            {"ends before"});
  }
}

TEST(ReadSurfaces, RefuseWhatIsNoTextFormat) {
  refuses("a.obj", "hello world\n", {"unknown statement \"hello\"", "line 1"});
  refuses("a.obj", "v 0 0 0\nv 1 0\n", {"fewer than three", "line 2"});
  refuses("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", {"names vertex 3 of 2", "line 3"});
  for (const char* index : {"0", "-3", "99999999999", "-9223372036854775808"})
    refuses("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 " + std::string(index), {"names vertex", "line 3"});
  refuses("a.obj", "v 0 0 0\nf 1 a 1\n", {"\"a\" is not an integer"});
  refuses("a.obj", "v 0 0 inf\n", {"not finite"});
  refuses("a.obj", "v 0 0 1e400\n", {"out of range"});
  refuses("a.off", "", {"ends before its header"});
  refuses("a.off", "OF\n", {"does not begin with OFF"});
  refuses("a.off", "OFF\n3\n", {"counts"});
  refuses("a.off", "OFF\n1 x 0\n", {"counts", "line 2"});
  refuses("a.off", "OFF\n2 0 0\n0 0 0\n", {"ends before vertex 1"});
  refuses("a.off", "OFF\n9999999999999 1 0\n0 0 0\n", {"ends before vertex 1"});
  refuses("a.off", "OFF\n1 1 0\n0 0 0\n3 0 0\n", {"not as many vertices as it says", "line 4"});
  refuses("a.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", {"names point 1 of 1"});
  refuses("a.off", "OFF BINARY\n\1\2\3", {"counts"});
  refuses("a.stl", "", {"no STL"});
  refuses("a.stl", std::string(84, 'x'), {"no STL", "2021161080 triangles"});
  refuses("a.stl", "solid\nvertex 0 0 0\n", {"vertex out of place"});
  refuses("a.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\nendloop\n", {"three vertices"});
  refuses("a.stl", "solid\nfacet\nouter loop\nvertex 0 0\n", {"vertex out of place"});
  refuses("a.stl", "solid\nfacet\n", {"ends within a solid"});
  refuses("a.stl", "solid\nhello\n", {"unknown word \"hello\"", "line 2"});
  refuses("a.txt", "OFF\n", {".vtp, .ply, .obj, .off or .stl"});
}

std::string vtp_text(const std::string& inside, const std::string& counts = "") {
  return "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"3\" " +
         (counts.empty() ? "NumberOfPolys=\"1\"" : counts) + ">" + inside +
         "</Piece></PolyData></VTKFile>";
}

TEST(ReadSurfaces, RefuseWhatIsNoVtp) {
  const std::string points =
      "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0"
      "</DataArray></Points>";
  const auto polys = [](const std::string& connectivity, const std::string& offsets) {
    return "<Polys><DataArray type=\"Int32\" Name=\"connectivity\">" + connectivity +
           "</DataArray><DataArray type=\"Int32\" Name=\"offsets\">" + offsets +
           "</DataArray></Polys>";
  };
  const std::string good = points + polys("0 1 2", "3");
  EXPECT_EQ(read_surface_file(put("good.vtp", vtp_text(good))).polygons.size(), 1u);
  refuses("a.vtp", vtp_text(good + polys("0 2 1", "3")), {"two sections Polys"});
  refuses("a.vtp", vtp_text(good + points), {"two sections Points"});
  refuses("a.vtp", vtp_text(good + "<PointData/><PointData/>"), {"two sections PointData"});
  refuses("a.vtp", vtp_text(points), {"no array offsets"});
  refuses("a.vtp", vtp_text(polys("0 1 2", "3")), {"no array in <Points>"});
  refuses("a.vtp", vtp_text(points + polys("0 1 3", "3")), {"names point 3 of 3"});
  refuses("a.vtp", vtp_text(points + polys("0 1 -1", "3")), {"names point -1 of 3"});
  refuses("a.vtp", vtp_text(points + polys("0 1 2", "-3")), {"offsets are negative"});
  refuses("a.vtp", vtp_text(points + polys("0 1 2", "4")), {"ends before 4 numbers"});
  refuses("a.vtp", vtp_text(points + polys("0 1 2", "3 2"), "NumberOfPolys=\"2\""),
          {"more than the 2 numbers"});
  refuses("a.vtp", vtp_text(good, "NumberOfPolys=\"99999999999\""), {"99999999999"});
  refuses("a.vtp", vtp_text(good, "NumberOfPolys=\"-1\""), {"no usable NumberOfPolys"});
  const auto array = [](const std::string& attributes, const std::string& numbers) {
    return "<PointData><DataArray type=\"Float64\" Name=\"a\" " + attributes + ">" + numbers +
           "</DataArray></PointData>";
  };
  refuses("a.vtp", vtp_text(good + array("", "1 2")), {"`a`", "ends before 3 numbers"});
  refuses("a.vtp", vtp_text(good + array("NumberOfComponents=\"9999\"", "1 2")),
          {"`a`", "too many components"});
  refuses("a.vtp", vtp_text(good + array("format=\"binary\"", "AAAA")), {"`a`", "byte_order"});
  refuses("a.vtp", "<VTKFile type=\"UnstructuredGrid\"/>", {"\"UnstructuredGrid\""});
  refuses("a.vtp", "<VTKFile type=\"PolyData\"><PolyData/></VTKFile>", {"no element Piece"});
}

TEST(ReadSurfaces, TakeRegularFilesOnly) {
  const auto folder = temporary("folder.ply");
  std::filesystem::create_directories(folder);
  const auto pipe = temporary("pipe.ply");
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto device = temporary("device.ply");
  std::filesystem::remove(device);
  std::filesystem::create_symlink("/dev/zero", device);
  for (const auto& file : {folder, pipe, device, temporary("missing.ply")}) {
    const IoError error = surface_error(file);
    EXPECT_EQ(error.kind(), IoError::Kind::unreadable) << error.what();
    EXPECT_THROW(read_text(file), IoError);
  }
}

TEST(ReadSurfaces, PolygonsAreCutAtTheirEars) {
  // An L, which a fan from its first corner would leave.
  const auto file = put("l.off",
                        "OFF\n6 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 0\n2 0 0\n2 1 0\n6 0 1 2 3 4 5\n");
  const SurfaceFile read = read_surface_file(file);
  const auto triangles = triangulated(read);
  ASSERT_EQ(triangles.size(), 4u);
  double area = 0;
  for (const auto& t : triangles) {
    const auto at = [&](std::size_t i) { return read.points[static_cast<std::size_t>(t[i])]; };
    const double twice = cross(at(1) - at(0), at(2) - at(0)).z;
    EXPECT_GT(twice, 0);
    area += twice / 2;
  }
  EXPECT_EQ(area, 3);
  std::vector<std::size_t> of;
  triangulated(read, &of);
  EXPECT_EQ(of, (std::vector<std::size_t>{0, 0, 0, 0}));
}

}  // namespace
}  // namespace tensortopo::test
