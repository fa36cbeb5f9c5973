// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/vtk_contours.hpp"

// vtkSMPTools.h of VTK 9.1 is no C++20; what it stands on is.
#include <SMP/Common/vtkSMPToolsAPI.h>
#include <vtkCellArray.h>
#include <vtkContour3DLinearGrid.h>
#include <vtkContourGrid.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {

struct VtkContours::Grid {
  vtkNew<vtkUnstructuredGrid> grid;
};

VtkContours::VtkContours(const TetMesh& mesh, int threads) : grid_(std::make_unique<Grid>()) {
  vtk::detail::smp::vtkSMPToolsAPI::GetInstance().Initialize(threads);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  vtkNew<vtkDoubleArray> modes;
  modes->SetName("mode");
  modes->SetNumberOfValues(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const auto& p = mesh.points[i];
    const auto id = static_cast<vtkIdType>(i);
    points->SetPoint(id, p.x, p.y, p.z);
    modes->SetValue(id, mode_if_defined(deviator(mesh.tensors[i])).value_or(0));
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& tet : mesh.tets) {
    const vtkIdType corners[4]{tet[0], tet[1], tet[2], tet[3]};
    cells->InsertNextCell(4, corners);
  }
  grid_->grid->SetPoints(points);
  grid_->grid->SetCells(VTK_TETRA, cells);
  grid_->grid->GetPointData()->SetScalars(modes);
}

VtkContours::~VtkContours() = default;

std::size_t VtkContours::contour_grid(std::span<const double> values) {
  vtkNew<vtkContourGrid> contour;
  contour->SetInputData(grid_->grid);
  contour->ComputeNormalsOff();
  for (std::size_t i = 0; i < values.size(); ++i) {
    contour->SetValue(static_cast<int>(i), values[i]);
  }
  contour->Update();
  return static_cast<std::size_t>(contour->GetOutput()->GetNumberOfPolys());
}

std::size_t VtkContours::contour_3d_linear_grid(std::span<const double> values) {
  vtkNew<vtkContour3DLinearGrid> contour;
  contour->SetInputData(grid_->grid);
  contour->MergePointsOn();
  for (std::size_t i = 0; i < values.size(); ++i) {
    contour->SetValue(static_cast<int>(i), values[i]);
  }
  contour->Update();
  return static_cast<std::size_t>(
      vtkPolyData::SafeDownCast(contour->GetOutputDataObject(0))->GetNumberOfPolys());
}

}  // namespace tensortopo
