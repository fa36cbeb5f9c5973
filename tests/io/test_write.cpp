// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "field_files.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/io/write_text.hpp"

namespace tensortopo::test {
namespace {

constexpr auto unwritable = IoError::Kind::unwritable;

SurfaceMesh surface_of_two() {
  SurfaceMesh s;
  s.points = {{0.1, 1.0 / 3, -1e-30}, {1e30, 0, 0x1p-1074}, {0, 1, 0}, {-2.5, 1e-5, 1e5}};
  s.triangles = {{0, 1, 2}, {2, 1, 3}};
  s.mode = {0.5, 0.5, 0.5, 0.5};
  s.residual = {1e-17, 0, -1e-18, 0};
  s.normal = s.medium_eigenvector =
      s.dominant_eigenvector = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0.8, 0}};
  s.tet = {1, 0};
  s.component = {0, 0};
  return s;
}

TetMesh mesh_of_two() {
  TetMesh mesh;
  mesh.cell_ids = {70, 5000000000};
  return mesh;
}

std::size_t files_beside(const std::filesystem::path& file) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(file.parent_path()))
    ++count;
  return count;
}

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

TEST(WriteSurface, VtpLeavesOutEmptyArrays) {
  SurfaceMesh s;
  s.points = surface_of_two().points;
  s.triangles = surface_of_two().triangles;
  EXPECT_TRUE(write_surface(s, TetMesh{}, temporary("bare.vtp")).arrays.empty());
}

CurveMesh curve_of_three() {
  CurveMesh c;
  c.points = {{0.1, 0.2, 0.3}, {1, 2, 3}, {-1e-30, 1e30, 0}};
  c.lines = {{2, 0, 1}, {1, 2}};
  c.mode = {1, 1, 1};
  c.separation = {0.25, -1e-9, 4};
  c.residual = {1e-16, 0, 0};
  c.dominant_eigenvector = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  c.tet = {0, 1};
  c.component = {0, 0};
  return c;
}

// In VTK's order of cells: lines, then triangles.
TEST(WriteCurves, VtpHoldsLinesAndTrianglesWithTheirArrays) {
  const auto file = temporary("both.vtp");
  const SurfaceMesh s = surface_of_two();
  const CurveMesh c = curve_of_three();
  const WriteReport report = write_surface(s, c, mesh_of_two(), file);
  EXPECT_EQ(report.arrays.size(), 8u);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* const data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 7);
  ASSERT_EQ(data->GetNumberOfLines(), 2);
  ASSERT_EQ(data->GetNumberOfPolys(), 2);
  vtkIdType size = 0;
  const vtkIdType* cell = nullptr;
  data->GetLines()->GetCellAtId(0, size, cell);
  EXPECT_EQ(std::vector<vtkIdType>(cell, cell + size), (std::vector<vtkIdType>{6, 4, 5}));
  const auto points = [&](const char* name, vtkIdType i) {
    return data->GetPointData()->GetArray(name)->GetComponent(i, 0);
  };
  EXPECT_EQ(points("mode", 3), 0.5);
  EXPECT_EQ(points("mode", 4), 1);
  EXPECT_EQ(points("separation", 0), 0);
  EXPECT_EQ(points("separation", 5), -1e-9);
  EXPECT_EQ(points("normal", 3), 0.6);
  EXPECT_EQ(points("normal", 4), 0);
  EXPECT_EQ(points("dominant_eigenvector", 4), 1);
  const auto cells = [&](const char* name, vtkIdType i) {
    return data->GetCellData()->GetArray(name)->GetComponent(i, 0);
  };
  EXPECT_EQ(cells("tet", 0), 70);
  EXPECT_EQ(cells("tet", 2), 5e9);
  EXPECT_EQ(cells("component", 0), 1);
  EXPECT_EQ(cells("component", 2), 0);
}

TEST(WriteCurves, VtpOfCurvesAloneHasNoArraysOfSurfaces) {
  const auto arrays =
      write_surface(SurfaceMesh{}, curve_of_three(), mesh_of_two(), temporary("c.vtp")).arrays;
  EXPECT_EQ(arrays, (std::vector<std::string>{"mode", "dominant_eigenvector", "separation",
                                              "residual", "tet", "component"}));
}

TEST(WriteCurves, ObjHasPolylinesAndPlyHasEdges) {
  write_surface(surface_of_two(), curve_of_three(), mesh_of_two(), temporary("c.obj"));
  write_surface(surface_of_two(), curve_of_three(), mesh_of_two(), temporary("c.ply"));
  const std::string obj = slurp(temporary("c.obj")), ply = slurp(temporary("c.ply"));
  EXPECT_NE(obj.find("\nl 7 5 6\nl 6 7\n"), std::string::npos);
  EXPECT_NE(ply.find("element edge 3\nproperty int vertex1\nproperty int vertex2\nend_header\n"),
            std::string::npos);
  const std::size_t body = ply.find("end_header\n") + 11;
  ASSERT_EQ(ply.size(), body + 7 * 24 + 2 * 13 + 3 * 8);
  std::int32_t ends[2];
  std::memcpy(ends, ply.data() + body + 7 * 24 + 2 * 13, 8);
  EXPECT_EQ(ends[0], 6);
  EXPECT_EQ(ends[1], 4);
}

TEST(WriteCurves, AreRefusedWhereTheFormatHasNoLinesOrTheDataDoNotFit) {
  for (const char* name : {"c.stl", "c.off"})
    EXPECT_THROW(write_surface({}, curve_of_three(), mesh_of_two(), temporary(name)), IoError);
  CurveMesh c = curve_of_three();
  c.lines[1][1] = 3;
  EXPECT_THROW(write_surface({}, c, mesh_of_two(), temporary("x.vtp")), std::invalid_argument);
  c = curve_of_three();
  c.separation.pop_back();
  EXPECT_THROW(write_surface({}, c, mesh_of_two(), temporary("x.vtp")), std::invalid_argument);
  c = curve_of_three();
  c.lines.push_back({1});
  c.tet.push_back(0), c.component.push_back(0);
  EXPECT_THROW(write_surface({}, c, mesh_of_two(), temporary("x.vtp")), std::invalid_argument);
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
  ASSERT_EQ(ply.size(), body + 4 * 24 + 2 * 13);
  double y = 0;
  std::memcpy(&y, ply.data() + body + 8, 8);
  EXPECT_EQ(y, 1.0 / 3);
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
      EXPECT_NE(std::string(error.what()).find(".obj, .off, .ply, .stl, .vtp"), std::string::npos);
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

TEST(Write, ToNowhereFailsAndLeavesNothing) {
  const auto folder = temporary("missing");
  EXPECT_THROW(write_text(folder / "a.json", "{}"), IoError);
  EXPECT_THROW(write_surface(surface_of_two(), mesh_of_two(), folder / "a.vtp"), IoError);
  EXPECT_FALSE(std::filesystem::exists(folder));
  std::filesystem::create_directories(temporary("folder.vtp"));
  try {
    write_surface(surface_of_two(), mesh_of_two(), temporary("folder.vtp"));
    FAIL();
  } catch (const IoError& error) {
    EXPECT_EQ(error.kind(), unwritable);
    EXPECT_EQ(error.file(), temporary("folder.vtp"));
  }
}

/// Lets no file of this process grow beyond some bytes, as a full disk would.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    before_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit small{bytes, limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, before_);
  }

 private:
  void (*before_)(int);
  rlimit limit_{};
};

TEST(Write, OnAFullDiskTheOldFileStays) {
  TetMesh field = cube_field(12);
  SurfaceMesh s;
  s.points = field.points;
  for (const auto& t : field.tets) s.triangles.push_back({t[0], t[1], t[2]});
  for (const std::string name : {"a.vtp", "a.ply", "a.obj", "a.stl", "a.off", "a.vtu", "a.json"}) {
    const auto file = put(name, "before");
    const std::size_t files = files_beside(file);
    bool failed = false;
    {
      const SmallDisk disk(3000);
      try {
        if (name == "a.vtu")
          write_mesh(field, file);
        else if (name == "a.json")
          write_text(file, std::string(5000, 'x'));
        else
          write_surface(s, field, file);
      } catch (const IoError& error) {
        failed = error.kind() == unwritable && error.file() == file;
      }
    }
    EXPECT_TRUE(failed) << name;
    EXPECT_EQ(slurp(file), "before") << name;
    EXPECT_EQ(files_beside(file), files) << name;
  }
}

TEST(Write, ReplacesAnExistingFileAndLeavesNoOther) {
  const auto file = put("a.json", "old and longer");
  write_text(file, "new");
  EXPECT_EQ(slurp(file), "new");
  EXPECT_EQ(files_beside(file), 1u);
}

TEST(Write, ThroughALinkReplacesItsTarget) {
  const auto target = put("target.json", "old"), link = temporary("link.json");
  std::filesystem::remove(link);
  std::filesystem::create_symlink(target, link);
  write_text(link, "new");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(slurp(target), "new");
}

TEST(Write, ThroughALinkToNowhereMakesItsTarget) {
  const auto target = temporary("not_yet.json"), link = temporary("early.json");
  std::filesystem::remove(target);
  std::filesystem::remove(link);
  std::filesystem::create_symlink("not_yet.json", link);
  write_text(link, "new");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(slurp(target), "new");
}

TEST(Write, LeavesADeviceADevice) {
  write_text("/dev/null", "gone");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(Write, GivesThePermissionsOfAnyNewFile) {
  const auto file = temporary("a.json"), other = put("b.json", "");
  write_text(file, "x");
  EXPECT_EQ(std::filesystem::status(file).permissions(),
            std::filesystem::status(other).permissions());
}

TEST(Write, RelativeNamesAreOfTheCurrentFolder) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(temporary("x").parent_path());
  EXPECT_NO_THROW(write_text("here.json", "x"));
  EXPECT_TRUE(std::filesystem::exists("here.json"));
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace tensortopo::test
