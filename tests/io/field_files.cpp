// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "field_files.hpp"

#include <bit>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace tensortopo::test {

std::filesystem::path temporary(const std::string& name) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "tensortopo_io" /
                                       (std::string(info->test_suite_name()) + "." + info->name());
  std::filesystem::create_directories(folder);
  return folder / name;
}

std::filesystem::path put(const std::string& name, const std::string& bytes) {
  const auto file = temporary(name);
  std::filesystem::remove(file);  // writing over a file is slow on some file systems
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

std::string slurp(const std::filesystem::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

TetMesh cube_field(int n) {
  TetMesh mesh;
  const auto at = [&](int i, int j, int k) { return (i * (n + 1) + j) * (n + 1) + k; };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) {
        const double x = i, y = j, z = k;
        mesh.points.push_back({x / 3, y / 3, z / 3});
        mesh.tensors.push_back({std::sin(x + 2 * y), std::cos(y * z), std::exp(z - x), x / 7,
                                -y / 11, std::sqrt(z + 2)});
      }
  constexpr int paths[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};  // corners as bits
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        for (const auto& path : paths) {
          const auto corner = [&](int c) {
            return at(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
          };
          mesh.tets.push_back({corner(0), corner(path[0]), corner(path[1]), corner(7)});
          mesh.cell_ids.push_back(static_cast<std::int64_t>(mesh.cell_ids.size()));
        }
  return mesh;
}

double volume_of(const TetMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.tets) {
    const auto& p = mesh.points[static_cast<std::size_t>(t[0])];
    const auto edge = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(t[i])] - p; };
    sum += dot(edge(1), cross(edge(2), edge(3))) / 6;
  }
  return sum;
}

std::string TextVtu::array(const std::string& name, int components, const std::string& numbers,
                           const std::string& type) {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"ascii\">\n" + numbers + "\n</DataArray>\n";
}

std::string TextVtu::str() const {
  std::string s = "<?xml version=\"1.0\"?>\n<VTKFile " + header + ">\n<UnstructuredGrid>\n";
  s += "<Piece NumberOfPoints=\"" + points + "\" NumberOfCells=\"" + cells + "\">\n";
  s += "<PointData>\n" + point_data + "</PointData>\n<CellData>\n" + cell_data + "</CellData>\n";
  s += "<Points>\n" + array("Points", 3, coordinates) + "</Points>\n<Cells>\n";
  s += array("connectivity", 1, connectivity, "Int64") + array("offsets", 1, offsets, "Int64");
  s += array("types", 1, types, "UInt8") + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return s;
}

std::string text_legacy(const std::string& attributes) {
  return "# vtk DataFile Version 3.0\na field\nASCII\nDATASET UNSTRUCTURED_GRID\n"
         "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n" +
         attributes;
}

IoError error_of(const std::filesystem::path& file, const ReadOptions& options) {
  try {
    read_mesh(file, options);
  } catch (const IoError& error) {
    return error;
  }
  ADD_FAILURE() << "no error from " << file;
  return {IoError::Kind::invalid, file, "no error"};
}

void expect_error(const std::filesystem::path& file, IoError::Kind kind,
                  const std::vector<std::string>& parts, const ReadOptions& options) {
  const IoError error = error_of(file, options);
  const std::string what = error.what();
  EXPECT_EQ(error.kind(), kind) << what;
  EXPECT_EQ(error.file(), file);
  EXPECT_EQ(what.rfind(file.string() + ": ", 0), 0u) << what;
  EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  for (const std::string& part : parts)
    EXPECT_NE(what.find(part), std::string::npos) << "no \"" << part << "\" in: " << what;
}

namespace {

template <class Array>
vtkSmartPointer<Array> tensor_array(const TetMesh& mesh, int components) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName("the stress");  // a space: encoded in legacy files
  array->SetNumberOfComponents(components);
  constexpr const char* names[] = {"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  for (int i = 0; i < components && components == 6; ++i) array->SetComponentName(i, names[i]);
  for (const auto& t : mesh.tensors) {
    const double six[] = {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz};
    const double nine[] = {t.xx, t.xy, t.xz, t.xy, t.yy, t.yz, t.xz, t.yz, t.zz};
    array->InsertNextTuple(components == 6 ? six : nine);
  }
  return array;
}

vtkSmartPointer<vtkUnstructuredGrid> vtk_grid(const TetMesh& mesh, int components, bool single) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
  for (const auto& p : mesh.points) points->InsertNextPoint(p.x, p.y, p.z);
  grid->SetPoints(points);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("number");
  const vtkIdType triangle[] = {0, 1, 2};
  grid->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  numbers->InsertNextValue(7);
  for (const auto& tet : mesh.tets) {
    const vtkIdType corners[] = {tet[0], tet[1], tet[2], tet[3]};
    grid->InsertNextCell(VTK_TETRA, 4, corners);
    numbers->InsertNextValue(8);
  }
  grid->GetCellData()->SetScalars(numbers);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("displacement");
  vectors->SetNumberOfComponents(3);
  for (const auto& p : mesh.points) vectors->InsertNextTuple3(p.z, p.x, p.y);
  grid->GetPointData()->SetVectors(vectors);
  vtkNew<vtkStringArray> remark;
  remark->SetName("remark");
  remark->InsertNextValue("two words");
  remark->InsertNextValue("");
  remark->InsertNextValue(std::string(300, 'x'));
  grid->GetFieldData()->AddArray(remark);
  if (single)
    grid->GetPointData()->AddArray(tensor_array<vtkFloatArray>(mesh, components));
  else if (components == 9)
    grid->GetPointData()->SetTensors(tensor_array<vtkDoubleArray>(mesh, components));
  else
    grid->GetPointData()->AddArray(tensor_array<vtkDoubleArray>(mesh, components));
  return grid;
}

}  // namespace

void vtk_write_vtu(const TetMesh& mesh, const std::filesystem::path& file, const VtkStyle& style,
                   int components, bool single_precision) {
  using Mode = VtkStyle::Mode;
  using Compressor = VtkStyle::Compressor;
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(vtk_grid(mesh, components, single_precision));
  writer->SetFileName(file.c_str());
  if (style.mode == Mode::ascii) writer->SetDataModeToAscii();
  if (style.mode == Mode::binary) writer->SetDataModeToBinary();
  if (style.mode == Mode::appended_base64 || style.mode == Mode::appended_raw)
    writer->SetDataModeToAppended();
  writer->SetEncodeAppendedData(style.mode == Mode::appended_base64);
  if (style.compressor == Compressor::none) writer->SetCompressorTypeToNone();
  if (style.compressor == Compressor::zlib) writer->SetCompressorTypeToZLib();
  if (style.compressor == Compressor::lz4) writer->SetCompressorTypeToLZ4();
  if (style.compressor == Compressor::lzma) writer->SetCompressorTypeToLZMA();
  writer->SetBlockSize(style.block);
  style.wide_header ? writer->SetHeaderTypeToUInt64() : writer->SetHeaderTypeToUInt32();
  style.big_endian ? writer->SetByteOrderToBigEndian() : writer->SetByteOrderToLittleEndian();
  ASSERT_EQ(writer->Write(), 1);
}

void vtk_write_legacy(const TetMesh& mesh, const std::filesystem::path& file, bool binary,
                      bool version_5, int components) {
  vtkNew<vtkUnstructuredGridWriter> writer;
  writer->SetInputData(vtk_grid(mesh, components, false));
  writer->SetFileName(file.c_str());
  binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
  writer->SetFileVersion(version_5 ? vtkDataWriter::VTK_LEGACY_READER_VERSION_5_1
                                   : vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2);
  ASSERT_EQ(writer->Write(), 1);
}

void expect_same_field(const TetMesh& is, const TetMesh& should) {
  const auto same = [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  };
  ASSERT_EQ(is.points.size(), should.points.size());
  ASSERT_EQ(is.tensors.size(), should.tensors.size());
  for (std::size_t i = 0; i < is.points.size(); ++i) {
    const auto &p = is.points[i], &q = should.points[i];
    EXPECT_TRUE(same(p.x, q.x) && same(p.y, q.y) && same(p.z, q.z)) << "point " << i;
    const auto &s = is.tensors[i], &t = should.tensors[i];
    EXPECT_TRUE(same(s.xx, t.xx) && same(s.yy, t.yy) && same(s.zz, t.zz) && same(s.xy, t.xy) &&
                same(s.yz, t.yz) && same(s.xz, t.xz))
        << "tensor " << i;
  }
  EXPECT_EQ(is.tets, should.tets);
}

}  // namespace tensortopo::test
