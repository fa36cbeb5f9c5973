// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include "field_files.hpp"
#include "support/compared.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "write_case.hpp"

namespace tensortopo::test {
namespace {

TEST(WriteSurface, VtpHoldsAllArraysExactly) {
  SurfaceMesh s = surface_of_two();
  s.points[1] = {1e300, -1e-300, 0x1p-1074};
  const auto file = temporary("surface.vtp");
  const WriteReport report = write_surface(s, mesh_of_two(), file);
  EXPECT_EQ(report.arrays,
            (std::vector<std::string>{"mode", "medium_eigenvector", "dominant_eigenvector",
                                      "normal", "residual", "tet", "component"}));
  EXPECT_EQ(report.bytes, std::filesystem::file_size(file));
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 4);
  ASSERT_EQ(data->GetNumberOfPolys(), 2);
  for (vtkIdType i = 0; i < 4; ++i) {
    double p[3];
    data->GetPoint(i, p);
    const auto& q = s.points[static_cast<std::size_t>(i)];
    EXPECT_TRUE(p[0] == q.x && p[1] == q.y && p[2] == q.z);
  }
  EXPECT_EQ(data->GetPointData()->GetArray("residual")->GetTuple1(0), 1e-17);
  EXPECT_EQ(data->GetPointData()->GetArray("normal")->GetComponent(3, 1), 0.8);
  EXPECT_EQ(data->GetCellData()->GetArray("tet")->GetTuple1(0), 5000000000.0);
  EXPECT_EQ(data->GetCellData()->GetArray("tet")->GetTuple1(1), 70.0);
  EXPECT_EQ(data->GetCellData()->GetArray("tet")->GetDataTypeSize(), 8);
  vtkIdType corners = 0;
  const vtkIdType* cell = nullptr;
  data->GetPolys()->GetCellAtId(1, corners, cell);
  EXPECT_EQ(std::vector<vtkIdType>(cell, cell + corners), (std::vector<vtkIdType>{2, 1, 3}));
}

// Blocks hold 65,536 bytes, and base64 takes three at a time: sizes around both.
TEST(WriteSurface, VtpHoldsArraysOfManyBlocksExactly) {
  for (const std::size_t count : {8191u, 8192u, 8193u, 30001u}) {
    Compared coordinates("coordinates and residuals", count);
    SurfaceMesh s;
    double x = 0.1;
    for (std::size_t i = 0; i < count; ++i) {
      x = 3.9 * x * (1 - x);
      s.points.push_back({x, static_cast<double>(i), -x});
      s.residual.push_back(x * 1e-16);
    }
    s.triangles.assign(count, {0, 1, 2});
    const auto file = temporary("many.vtp"), again = temporary("again.vtp");
    write_surface(s, TetMesh{}, file);
    {
      const oneapi::tbb::global_control one_thread(
          oneapi::tbb::global_control::max_allowed_parallelism, 1);
      write_surface(s, TetMesh{}, again);
    }
    EXPECT_EQ(slurp(file), slurp(again));
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkPolyData* const data = reader->GetOutput();
    ASSERT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(count));
    ASSERT_EQ(data->GetNumberOfPolys(), static_cast<vtkIdType>(count));
    vtkDataArray* const residual = data->GetPointData()->GetArray("residual");
    ASSERT_NE(residual, nullptr);
    for (std::size_t i = 0; i < count; ++i) {
      double p[3];
      data->GetPoint(static_cast<vtkIdType>(i), p);
      ASSERT_TRUE(p[0] == s.points[i].x && p[1] == s.points[i].y && p[2] == s.points[i].z) << i;
      ASSERT_EQ(residual->GetTuple1(static_cast<vtkIdType>(i)), s.residual[i]) << i;
      ++coordinates;
    }
  }
}

// ParaView 5.11 with a recent expat shows files with an AppendedData section as empty.
TEST(WriteSurface, BinaryDataIsInline) {
  const std::string surface = slurp([] {
    const auto file = temporary("surface.vtp");
    write_surface(surface_of_two(), curve_of_three(), mesh_of_two(), file, {}, {{"a", "b"}});
    return file;
  }());
  const auto mesh_file = temporary("mesh.vtu");
  write_mesh(cube_field(2), mesh_file);
  for (const std::string& bytes : {surface, slurp(mesh_file)}) {
    EXPECT_EQ(bytes.find("AppendedData"), std::string::npos);
    EXPECT_EQ(bytes.find("appended"), std::string::npos);
    EXPECT_NE(bytes.find("format=\"binary\""), std::string::npos);
    EXPECT_NE(bytes.find("compressor=\"vtkZLibDataCompressor\""), std::string::npos);
    for (const char c : bytes) ASSERT_TRUE(c == '\n' || (c >= ' ' && c <= '~'));
  }
  EXPECT_NE(slurp(mesh_file).find("Tensors=\"stress\""), std::string::npos);
}

TEST(WriteSurface, VtpMarksAttributesAndSaysWhereItComesFrom) {
  const auto file = temporary("surface.vtp");
  const std::vector<FileNote> notes{{"options", "--mode 1/2 <&\">"}, {"input_sha256", "0123"}};
  write_surface(surface_of_two(), CurveMesh{}, mesh_of_two(), file, {}, notes);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  ASSERT_NE(data->GetPointData()->GetNormals(), nullptr);
  EXPECT_STREQ(data->GetPointData()->GetNormals()->GetName(), "normal");
  ASSERT_NE(data->GetPointData()->GetScalars(), nullptr);
  EXPECT_STREQ(data->GetPointData()->GetScalars()->GetName(), "mode");
  ASSERT_EQ(data->GetFieldData()->GetNumberOfArrays(), 2);
  for (const FileNote& note : notes) {
    auto* text = vtkStringArray::SafeDownCast(
        data->GetFieldData()->GetAbstractArray(note.name.c_str()));
    ASSERT_NE(text, nullptr) << note.name;
    EXPECT_EQ(text->GetValue(0), note.text);
  }
}

TEST(WriteSurface, VtpLeavesOutEmptyArrays) {
  SurfaceMesh s;
  s.points = surface_of_two().points;
  s.triangles = surface_of_two().triangles;
  EXPECT_TRUE(write_surface(s, TetMesh{}, temporary("bare.vtp")).arrays.empty());
}

TEST(WriteSurface, TextFormatsReadBackExactly) {
  const SurfaceMesh s = surface_of_two();
  write_surface(s, mesh_of_two(), temporary("s.obj"));
  write_surface(s, mesh_of_two(), temporary("s.off"));
  std::ifstream obj(temporary("s.obj")), off(temporary("s.off"));
  std::string word;
  for (const auto& p : s.points) {
    std::string x, y, z;
    obj >> word >> x >> y >> z;
    EXPECT_EQ(word, "v");
    EXPECT_TRUE(std::stod(x) == p.x && std::stod(y) == p.y);
    EXPECT_EQ(std::strtod(z.c_str(), nullptr), p.z);
  }
  int a = 0, b = 0, c = 0;
  obj >> word >> a >> b >> c;
  EXPECT_EQ(word + std::to_string(a) + std::to_string(b) + std::to_string(c), "f123");
  off >> word >> a >> b >> c;
  EXPECT_EQ(word, "OFF");
  EXPECT_TRUE(a == 4 && b == 2);
  off >> word;
  EXPECT_EQ(std::stod(word), 0.1);
}

TEST(WriteSurface, BinaryFormatsHoldTheBytes) {
  const SurfaceMesh s = surface_of_two();
  write_surface(s, mesh_of_two(), temporary("s.ply"));
  write_surface(s, mesh_of_two(), temporary("s.stl"));
  const std::string ply = slurp(temporary("s.ply")), stl = slurp(temporary("s.stl"));
  const std::size_t body = ply.find("end_header\n") + 11;
  ASSERT_EQ(ply.size(), body + 4 * 32 + 2 * 13);
  double y = 0;
  std::memcpy(&y, ply.data() + body + 8, 8);
  EXPECT_EQ(y, 1.0 / 3);
  EXPECT_NE(ply.find("property double mode\n"), std::string::npos);
  std::memcpy(&y, ply.data() + body + 24, 8);
  EXPECT_EQ(y, 0.5);
  ASSERT_EQ(stl.size(), 84u + 2 * 50);
  EXPECT_NE(stl.substr(0, 5), "solid");
  float x = 0;
  std::memcpy(&x, stl.data() + 84 + 12, 4);
  EXPECT_EQ(x, 0.1f);
}

TEST(WriteSurface, StlRefusesWhatFloatCannotHold) {
  SurfaceMesh s = surface_of_two();
  s.points[0].x = 1e39;
  const auto file = temporary("large.stl");
  try {
    write_surface(s, mesh_of_two(), file);
    FAIL();
  } catch (const IoError& error) {
    EXPECT_EQ(error.kind(), unwritable);
    EXPECT_NE(std::string(error.what()).find("float32"), std::string::npos);
  }
  EXPECT_EQ(files_beside(file), 0u);
}

TEST(WriteSurface, SameSurfaceGivesTheSameBytes) {
  for (const std::string extension : {".vtp", ".ply", ".obj", ".stl", ".off"}) {
    write_surface(surface_of_two(), mesh_of_two(), temporary("one" + extension));
    write_surface(surface_of_two(), mesh_of_two(), temporary("two" + extension));
    EXPECT_EQ(slurp(temporary("one" + extension)), slurp(temporary("two" + extension)))
        << extension;
  }
}

// Whoever reads arrays by name finds those that any other file of the kind has.
TEST(WriteSurface, AnEmptyVtpHasTheArraysOfItsKind) {
  SurfaceMesh s = surface_of_two(), of_value = surface_of_two();
  of_value.value = of_value.mode;
  of_value.mode.clear(), of_value.medium_eigenvector.clear();
  of_value.dominant_eigenvector.clear();
  const struct {
    OutputKinds kinds;
    SurfaceMesh surface;
    CurveMesh curves;
  } cases[]{{{.mode_surfaces = true}, s, {}},
            {{.invariant_surfaces = true}, of_value, {}},
            {{.degenerate_curves = true}, {}, curve_of_three()},
            {{.mode_surfaces = true, .degenerate_curves = true}, s, curve_of_three()}};
  for (const auto& [kinds, surface, curves] : cases) {
    const auto full = write_surface(surface, curves, mesh_of_two(), temporary("full.vtp"), kinds);
    EXPECT_EQ(full.arrays,
              write_surface(surface, curves, mesh_of_two(), temporary("full.vtp")).arrays);
    const auto file = temporary("empty.vtp");
    EXPECT_EQ(write_surface({}, {}, mesh_of_two(), file, kinds).arrays, full.arrays);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkPolyData* const data = reader->GetOutput();
    EXPECT_EQ(data->GetNumberOfPoints(), 0);
    EXPECT_EQ(data->GetPointData()->GetNumberOfArrays() + data->GetCellData()->GetNumberOfArrays(),
              static_cast<int>(full.arrays.size()));
    vtkNew<vtkXMLPolyDataReader> other;
    other->SetFileName(temporary("full.vtp").c_str());
    other->Update();
    for (const std::string& name : full.arrays) {
      vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
      vtkDataArray* like = other->GetOutput()->GetPointData()->GetArray(name.c_str());
      if (like == nullptr) {
        array = data->GetCellData()->GetArray(name.c_str());
        like = other->GetOutput()->GetCellData()->GetArray(name.c_str());
      }
      ASSERT_TRUE(array != nullptr && like != nullptr) << name;
      EXPECT_EQ(array->GetNumberOfTuples(), 0) << name;
      EXPECT_EQ(array->GetNumberOfComponents(), like->GetNumberOfComponents()) << name;
      EXPECT_EQ(array->GetDataType(), like->GetDataType()) << name;
    }
  }
}

TEST(LowerExtension, IsWhatTellsTheFormat) {
  EXPECT_EQ(lower_extension("some.Folder/S.x.VTP"), ".vtp");
  EXPECT_EQ(lower_extension("s.vtp"), ".vtp");
  EXPECT_EQ(lower_extension("VTP"), "");
  EXPECT_EQ(lower_extension("S.\xC3\x89"), ".\xC3\x89");  // not ASCII: as it is
}

TEST(WriteSurface, EmptySurfacesAreWritten) {
  for (const std::string extension : {".vtp", ".ply", ".obj", ".stl", ".off"}) {
    write_surface(SurfaceMesh{}, TetMesh{}, temporary("none" + extension));
    EXPECT_TRUE(std::filesystem::exists(temporary("none" + extension)));
  }
}

TEST(WriteSurface, UnknownExtensionsAreRefusedWithTheKnown) {
  for (const std::string name : {"surface.xyz", "surface"}) {
    try {
      write_surface(surface_of_two(), mesh_of_two(), temporary(name));
      FAIL();
    } catch (const IoError& error) {
      EXPECT_EQ(error.kind(), unwritable);
      EXPECT_NE(std::string(error.what()).find(".vtp, .ply, .obj, .off or .stl"), std::string::npos);
    }
  }
}

TEST(WriteSurface, InconsistentSurfacesAreTheCallersFault) {
  const auto file = temporary("bad.vtp");
  SurfaceMesh s = surface_of_two();
  s.mode.pop_back();
  EXPECT_THROW(write_surface(s, mesh_of_two(), file), std::invalid_argument);
  s = surface_of_two();
  s.triangles[1][2] = 4;
  EXPECT_THROW(write_surface(s, mesh_of_two(), file), std::invalid_argument);
  s = surface_of_two();
  s.tet[0] = 2;
  EXPECT_THROW(write_surface(s, mesh_of_two(), file), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(WriteMesh, WritesNothingUnderANameThatNobodyReads) {
  for (const char* name : {"none.vtk", "none.foo", "none", "none.vtp"}) {
    EXPECT_THROW(write_mesh(cube_field(2), temporary(name)), IoError);
    EXPECT_FALSE(std::filesystem::exists(temporary(name)));
  }
  EXPECT_THROW(write_piece_list({}, temporary("none.vtu")), IoError);
  write_mesh(cube_field(2), temporary("mesh.VTU"));
  EXPECT_TRUE(std::filesystem::exists(temporary("mesh.VTU")));
}

}  // namespace
}  // namespace tensortopo::test
