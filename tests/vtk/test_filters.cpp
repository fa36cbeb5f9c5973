// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "slab_grid.hpp"
#include "tensortopo/io/temporary_folder.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/modes/mode_extractor.hpp"
#include "vtkTensorDegenerateCurves.h"
#include "vtkTensorModeSurface.h"

namespace tensortopo {
namespace {

/// What a filter complains of.
struct Complaints {
  std::string text;
  explicit Complaints(vtkObject* object) {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void* data) {
      static_cast<Complaints*>(self)->text += static_cast<const char*>(data);
    });
    object->AddObserver(vtkCommand::ErrorEvent, command);
  }
};

vtkSmartPointer<vtkPolyData> written(const ModeSurfaces* surfaces, const DegenerateCurves* curves) {
  TemporaryFolder folder;
  const auto file = folder.file("out.vtp");
  write_surface(surfaces != nullptr ? surfaces->surface : SurfaceMesh{},
                curves != nullptr ? curves->curves : CurveMesh{}, slab(), file, {});
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// Compares points, cells and arrays, bit for bit; how many arrays.
int expect_same(vtkPolyData* ours, vtkPolyData* theirs) {
  EXPECT_EQ(ours->GetNumberOfPoints(), theirs->GetNumberOfPoints());
  EXPECT_EQ(ours->GetNumberOfCells(), theirs->GetNumberOfCells());
  EXPECT_GT(ours->GetNumberOfCells(), 20);
  int compared = 0;
  const auto expect_equal = [&](vtkDataArray* a, vtkDataArray* b) {
    ASSERT_TRUE(a != nullptr && b != nullptr);
    ASSERT_EQ(a->GetNumberOfComponents(), b->GetNumberOfComponents()) << b->GetName();
    ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples()) << b->GetName();
    for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
      for (int k = 0; k < a->GetNumberOfComponents(); ++k)
        ASSERT_EQ(a->GetComponent(i, k), b->GetComponent(i, k)) << b->GetName() << " at " << i;
    ++compared;
  };
  expect_equal(ours->GetPoints()->GetData(), theirs->GetPoints()->GetData());
  for (int i = 0; i < theirs->GetPointData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = theirs->GetPointData()->GetArray(i);
    expect_equal(ours->GetPointData()->GetArray(array->GetName()), array);
  }
  for (int i = 0; i < theirs->GetCellData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = theirs->GetCellData()->GetArray(i);
    expect_equal(ours->GetCellData()->GetArray(array->GetName()), array);
  }
  for (const auto& [a, b] : {std::pair{ours->GetPolys(), theirs->GetPolys()},
                             std::pair{ours->GetLines(), theirs->GetLines()}}) {
    if (a->GetNumberOfCells() == 0 && b->GetNumberOfCells() == 0) continue;
    expect_equal(a->GetConnectivityArray(), b->GetConnectivityArray());
    expect_equal(a->GetOffsetsArray(), b->GetOffsetsArray());
  }
  return compared;
}

TEST(VtkFilters, GiveTheBitsThatTheProgramWrites) {
  const ModeExtractor extractor(slab());
  const auto grid = grid_of(slab());
  vtkNew<vtkTensorModeSurface> filter;
  filter->SetInputData(grid);
  filter->SetModes("1/2, -0.9");
  filter->SetGeneralized(true);
  filter->SetCurves(3);
  filter->Update();
  SurfaceRequest request;
  request.modes = {ModeValue::parse("1/2"), ModeValue::parse("-9/10")};
  request.generalized = true;
  const ModeSurfaces surfaces = extractor.surfaces(request);
  EXPECT_GE(expect_same(filter->GetOutput(0), written(&surfaces, nullptr)), 9);
  CurveRequest both;
  both.planar = true;
  const DegenerateCurves curves = extractor.curves(both);
  EXPECT_GE(expect_same(filter->GetOutput(1), written(nullptr, &curves)), 8);

  vtkNew<vtkTensorDegenerateCurves> alone;
  alone->SetInputData(grid);
  alone->Update();
  EXPECT_GE(expect_same(alone->GetOutput(0), written(nullptr, &curves)), 8);
}

TEST(VtkFilters, UncertaintyMarksTriangles) {
  vtkNew<vtkTensorModeSurface> filter;
  filter->SetInputData(grid_of(slab()));
  filter->SetModes("0.5, -0.5");
  filter->SetUncertainty("1%");
  filter->Update();
  SurfaceRequest request;
  request.modes = {ModeValue::parse("1/2"), ModeValue::parse("-1/2")};
  request.uncertainty = parse_uncertainty("1%");
  const ModeSurfaces expected = ModeExtractor(slab()).surfaces(request);
  EXPECT_GE(expect_same(filter->GetOutput(0), written(&expected, nullptr)), 9);
  ASSERT_EQ(expected.more.size(), 4u);
  for (const CellArray& array : expected.more) {
    vtkPolyData* output = filter->GetOutput(0);
    vtkDataSetAttributes* data = array.of_points
                                     ? static_cast<vtkDataSetAttributes*>(output->GetPointData())
                                     : output->GetCellData();
    vtkDataArray* found = data->GetArray(array.name.c_str());
    ASSERT_NE(found, nullptr) << array.name;
    ASSERT_EQ(static_cast<std::size_t>(found->GetNumberOfTuples()), array.values.size());
    for (std::size_t i = 0; i < array.values.size(); ++i)
      ASSERT_EQ(found->GetComponent(static_cast<vtkIdType>(i), 0), array.values[i]) << i;
    const auto [low, high] = std::minmax_element(array.values.begin(), array.values.end());
    EXPECT_LT(*low, *high) << array.name;
  }
  filter->SetUncertainty("much");
  const Complaints complaints(filter);
  vtkNew<vtkCallbackCommand> ignore;
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, ignore);
  filter->Update();
  EXPECT_NE(complaints.text.find("neither a number"), std::string::npos) << complaints.text;
}

TEST(VtkFilters, ASlidersNumberIsItsShortestDecimal) {
  const auto grid = grid_of(slab());
  vtkNew<vtkTensorModeSurface> text, slider;
  text->SetInputData(grid), slider->SetInputData(grid);
  text->SetModes("3/10");
  slider->SetUseModeNumber(true), slider->SetModeNumber(0.3);
  text->Update(), slider->Update();
  EXPECT_GE(expect_same(slider->GetOutput(0), text->GetOutput(0)), 9);
}

TEST(VtkFilters, OtherOrdersOfComponentsAreTakenAsChosenOrNamed) {
  auto grid = grid_of(slab());
  vtkNew<vtkTensorModeSurface> plain;
  plain->SetInputData(grid);
  plain->SetModes("0.5");
  plain->Update();
  const auto fsl = grid_of(slab());
  vtkDataArray* rows = fsl->GetPointData()->GetArray("S");
  constexpr int place[6]{0, 3, 5, 1, 4, 2};  // of VTK's six, for FSL's
  const char* names[6]{"Sxx", "Sxy", "Sxz", "Syy", "Syz", "Szz"};
  for (vtkIdType i = 0; i < rows->GetNumberOfTuples(); ++i) {
    double t[6], s[6];
    rows->GetTuple(i, t);
    for (int k = 0; k < 6; ++k) s[k] = t[place[k]];
    rows->SetTuple(i, s);
  }
  vtkNew<vtkTensorModeSurface> chosen;
  chosen->SetInputData(fsl);
  chosen->SetModes("0.5");
  chosen->SetComponentOrder(5);
  chosen->Update();
  EXPECT_GE(expect_same(chosen->GetOutput(0), plain->GetOutput(0)), 9);
  for (int k = 0; k < 6; ++k) rows->SetComponentName(k, names[k]);
  chosen->SetComponentOrder(0);
  rows->Modified(), fsl->Modified();
  chosen->Update();
  EXPECT_GE(expect_same(chosen->GetOutput(0), plain->GetOutput(0)), 9);
  chosen->SetComponentOrder(1);
  const Complaints complaints(chosen);
  chosen->Update();
  EXPECT_NE(complaints.text.find("fsl"), std::string::npos) << complaints.text;
}

TEST(VtkFilters, CellsWithoutAProofAreAnOutput) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tensors.assign(4, {1, 0, -1, 0, 0, 0});
  mesh.tets = {{0, 1, 2, 3}};
  mesh.cell_ids = {0};
  vtkNew<vtkTensorModeSurface> filter;
  filter->SetInputData(grid_of(mesh));
  filter->Update();
  auto* cells = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(2));
  ASSERT_EQ(cells->GetNumberOfCells(), 1);
  auto* reasons = vtkStringArray::SafeDownCast(cells->GetCellData()->GetAbstractArray("reason"));
  EXPECT_EQ(reasons->GetValue(0), "level_constant_in_cell");
}

TEST(VtkFilters, CertificatesAreThoseOfTheLibrary) {
  TemporaryFolder folder;
  const std::string file = folder.file("c.json").string();
  vtkNew<vtkTensorModeSurface> filter;
  filter->SetInputData(grid_of(slab()));
  filter->SetModes("0.5");
  filter->SetCertificateFile(file.c_str());
  filter->Update();
  SurfaceRequest request;
  request.modes = {ModeValue::parse("1/2")};
  request.certify = true;
  request.names.tensor = "S";
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  EXPECT_GT(bytes.str().size(), 1000u);
  EXPECT_EQ(bytes.str(), ModeExtractor(slab()).surfaces(request).certificate);
}

TEST(VtkFilters, WrongInputIsAnErrorWithItsReason) {
  const auto message = [](vtkUnstructuredGrid* grid, const char* modes) {
    vtkNew<vtkTensorModeSurface> filter;
    filter->SetInputData(grid);
    filter->SetModes(modes);
    const Complaints complaints(filter);
    vtkNew<vtkCallbackCommand> ignore;  // the executive complains that the filter failed
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, ignore);
    filter->Update();
    EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
    return complaints.text;
  };
  const auto grid = grid_of(slab());
  EXPECT_NE(message(grid, "2").find("[-1, 1]"), std::string::npos);
  EXPECT_NE(message(grid, "").find("no mode"), std::string::npos);
  EXPECT_NE(message(grid, "1").find("degenerate curves"), std::string::npos);
  const vtkIdType twice[4]{0, 1, 1, 2};
  const auto broken = grid_of(slab());
  broken->InsertNextCell(VTK_TETRA, 4, twice);
  EXPECT_FALSE(message(broken, "0").empty());
  const auto hexahedron = grid_of(slab());
  const vtkIdType eight[8]{0, 1, 2, 3, 4, 5, 6, 7};
  hexahedron->InsertNextCell(VTK_HEXAHEDRON, 8, eight);
  EXPECT_NE(message(hexahedron, "0").find("linear tetrahedra"), std::string::npos);
  const auto without = grid_of(slab());
  without->GetPointData()->RemoveArray("S");
  EXPECT_NE(message(without, "0").find("no point array"), std::string::npos);
}

TEST(VtkFilters, AbortEndsWithoutAnError) {
  std::string modes;
  for (int i = 1; i < 900; ++i) modes += "0." + std::to_string(1000 + i) + " ";
  vtkNew<vtkTensorModeSurface> filter;
  filter->SetInputData(grid_of(slab()));
  filter->SetModes(modes.c_str());
  const Complaints complaints(filter);
  int reports = 0;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&reports);
  command->SetCallback([](vtkObject* object, unsigned long, void* count, void*) {
    auto* algorithm = vtkAlgorithm::SafeDownCast(object);
    // Before and after the filter's own reports the executive reports 0 and 1.
    if (algorithm->GetProgressText() == nullptr) return;
    ++*static_cast<int*>(count);
    algorithm->SetAbortExecute(1);
  });
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
  EXPECT_GE(reports, 1);
  EXPECT_EQ(complaints.text, "");
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
}

/// The points of pieces that were read into one grid are one where they have one global id.
TEST(VtkFilters, PointsOfOneIdAreOne) {
  const TetMesh& mesh = slab();
  const auto whole = grid_of(mesh);
  TetMesh doubled = mesh;
  std::vector<TetMesh::Index> second(mesh.points.size(), -1);
  vtkNew<vtkIdTypeArray> ids;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    ids->InsertNextValue(static_cast<vtkIdType>(v));
  for (std::size_t t = 0; t < mesh.tets.size(); t += 2)
    for (auto& v : doubled.tets[t]) {
      auto& copy = second[static_cast<std::size_t>(v)];
      if (copy < 0) {
        copy = static_cast<TetMesh::Index>(doubled.points.size());
        doubled.points.push_back(mesh.points[static_cast<std::size_t>(v)]);
        doubled.tensors.push_back(mesh.tensors[static_cast<std::size_t>(v)]);
        ids->InsertNextValue(v);
      }
      v = copy;
    }
  const auto grid = grid_of(doubled);
  grid->GetPointData()->SetGlobalIds(ids);
  vtkNew<vtkTensorModeSurface> one, two;
  one->SetInputData(whole), two->SetInputData(grid);
  one->SetModes("0.5"), two->SetModes("0.5");
  one->Update(), two->Update();
  EXPECT_GE(expect_same(two->GetOutput(0), one->GetOutput(0)), 9);
  grid->GetPointData()->SetGlobalIds(nullptr);
  two->Modified();
  two->Update();
  EXPECT_NE(two->GetOutput(0)->GetNumberOfPoints(), one->GetOutput(0)->GetNumberOfPoints());
}

/// The whole surface is counted in field arrays, one number for each mode.
TEST(VtkFilters, CountTheWholeSurface) {
  vtkNew<vtkTensorModeSurface> filter;
  filter->SetInputData(grid_of(slab()));
  filter->SetModes("0.5, -0.9");
  filter->SetNumberOfCells(static_cast<vtkIdType>(slab().tets.size()));
  filter->Update();
  SurfaceRequest request;
  request.modes = {ModeValue::parse("1/2"), ModeValue::parse("-9/10")};
  const ModeSurfaces expected = ModeExtractor(slab()).surfaces(request);
  vtkFieldData* data = filter->GetOutput(0)->GetFieldData();
  const auto number = [&](const char* name, vtkIdType i) {
    return data->GetArray(name)->GetComponent(i, 0);
  };
  ASSERT_EQ(expected.parts.size(), 2u);
  for (vtkIdType i = 0; i < 2; ++i) {
    const ModePart& part = expected.parts[static_cast<std::size_t>(i)];
    EXPECT_EQ(number("surface_mode", i), part.mode.approx());
    EXPECT_EQ(number("components", i), static_cast<double>(part.invariants.components));
    EXPECT_EQ(number("euler_characteristic", i),
              static_cast<double>(part.invariants.euler_characteristic));
    EXPECT_EQ(number("boundary_loops", i), static_cast<double>(part.invariants.boundary_loops));
  }
  filter->SetNumberOfCells(static_cast<vtkIdType>(slab().tets.size()) + 1);
  const Complaints complaints(filter);
  vtkNew<vtkCallbackCommand> ignore;
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, ignore);
  filter->Update();
  EXPECT_NE(complaints.text.find("NumberOfCells"), std::string::npos) << complaints.text;
}

}  // namespace
}  // namespace tensortopo
