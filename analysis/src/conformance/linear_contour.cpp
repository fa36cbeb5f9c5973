// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "conformance/linear_contour.hpp"

#include <vtkCellArray.h>
#include <vtkContourGrid.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {

SurfaceMesh linear_contour(const TetMesh& mesh, const ModeValue& mode) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> modes;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    points->InsertNextPoint(mesh.points[i].x, mesh.points[i].y, mesh.points[i].z);
    modes->InsertNextValue(mode_if_defined(deviator(mesh.tensors[i])).value_or(0));
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& tet : mesh.tets) {
    const vtkIdType corners[4]{tet[0], tet[1], tet[2], tet[3]};
    cells->InsertNextCell(4, corners);
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->SetCells(VTK_TETRA, cells);
  grid->GetPointData()->SetScalars(modes);

  vtkNew<vtkContourGrid> contour;
  contour->SetInputData(grid);
  contour->ComputeNormalsOff();
  contour->SetValue(0, mode.approx());
  contour->Update();
  vtkPolyData* data = contour->GetOutput();
  SurfaceMesh surface;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double p[3];
    data->GetPoint(i, p);
    surface.points.push_back({p[0], p[1], p[2]});
  }
  vtkNew<vtkIdList> corners;
  vtkCellArray* polygons = data->GetPolys();
  for (polygons->InitTraversal(); polygons->GetNextCell(corners);)
    for (vtkIdType i = 2; i < corners->GetNumberOfIds(); ++i)
      surface.triangles.push_back({static_cast<SurfaceMesh::Index>(corners->GetId(0)),
                                   static_cast<SurfaceMesh::Index>(corners->GetId(i - 1)),
                                   static_cast<SurfaceMesh::Index>(corners->GetId(i))});
  return surface;
}

}  // namespace tensortopo
