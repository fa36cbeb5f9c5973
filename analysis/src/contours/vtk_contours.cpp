// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "contours/vtk_contours.hpp"

// vtkSMPTools.h of VTK 9.1 is no C++20; what it stands on is.
#include <SMP/Common/vtkSMPToolsAPI.h>
#include <vtkCellArray.h>
#include <vtkContour3DLinearGrid.h>
#include <vtkContourGrid.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {
namespace {

using Index = SurfaceMesh::Index;

std::size_t as_size(Index i) { return static_cast<std::size_t>(i); }

vtkSmartPointer<vtkUnstructuredGrid> grid_of(const TetMesh& mesh) {
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
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(VTK_TETRA, cells);
  grid->GetPointData()->SetScalars(modes);
  return grid;
}

/// Six times the volume times the slope along `direction` of the modes at the vertices.
double slope_along(const Vector3<double>& direction, const TetMesh& mesh, vtkDataArray& modes,
                   Index tet) {
  const auto& v = mesh.tets[as_size(tet)];
  const auto& p = mesh.points[as_size(v[0])];
  const auto at = [&](std::size_t i) { return mesh.points[as_size(v[i])] - p; };
  const auto rise = [&](std::size_t i) { return modes.GetTuple1(v[i]) - modes.GetTuple1(v[0]); };
  const Vector3<double> gradient = rise(1) * cross(at(2), at(3)) + rise(2) * cross(at(3), at(1)) +
                                   rise(3) * cross(at(1), at(2));
  return dot(direction, gradient);
}

/// The tetrahedron that holds a point, or lacks least of it.
Index tet_around(const Vector3<double>& x, const TetMesh& mesh, vtkStaticCellLocator& locator) {
  double bounds[6]{x.x, x.x, x.y, x.y, x.z, x.z};
  vtkNew<vtkIdList> near;
  locator.FindCellsWithinBounds(bounds, near);
  if (near->GetNumberOfIds() == 0) {
    double at[3]{x.x, x.y, x.z}, closest[3], squared;
    vtkIdType cell = 0;
    int part;
    locator.FindClosestPoint(at, closest, cell, part, squared);
    return static_cast<Index>(cell);
  }
  Index best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; i < near->GetNumberOfIds(); ++i) {
    const auto t = static_cast<Index>(near->GetId(i));
    const auto& v = mesh.tets[as_size(t)];
    const auto p = [&](std::size_t k) { return mesh.points[as_size(v[k % 4])]; };
    double least = 1;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto normal = cross(p(k + 2) - p(k + 1), p(k + 3) - p(k + 1));
      least = std::min(least, dot(normal, x - p(k + 1)) / dot(normal, p(k) - p(k + 1)));
    }
    if (least > most) most = least, best = t;
  }
  return best;
}

vtkSmartPointer<vtkPolyData> contour(vtkUnstructuredGrid* grid, double value, VtkFilter filter) {
  if (filter == VtkFilter::contour_grid) {
    vtkNew<vtkContourGrid> contour;
    contour->SetInputData(grid);
    contour->ComputeNormalsOff();
    contour->SetValue(0, value);
    contour->Update();
    return contour->GetOutput();
  }
  vtkNew<vtkContour3DLinearGrid> contour;
  contour->SetInputData(grid);
  contour->MergePointsOn();
  contour->SetSequentialProcessing(true);  // threads change the order
  contour->SetValue(0, value);
  contour->Update();
  return vtkPolyData::SafeDownCast(contour->GetOutputDataObject(0));
}

/// `points` and `triangles`.
SurfaceMesh triangles_of(vtkPolyData& data) {
  SurfaceMesh surface;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    double p[3];
    data.GetPoint(i, p);
    surface.points.push_back({p[0], p[1], p[2]});
  }
  vtkNew<vtkIdList> corners;
  vtkCellArray* polygons = data.GetPolys();
  for (polygons->InitTraversal(); polygons->GetNextCell(corners);)
    for (vtkIdType i = 2; i < corners->GetNumberOfIds(); ++i)
      surface.triangles.push_back({static_cast<Index>(corners->GetId(0)),
                                   static_cast<Index>(corners->GetId(i - 1)),
                                   static_cast<Index>(corners->GetId(i))});
  return surface;
}

}  // namespace

struct VtkContours::Grid {
  vtkSmartPointer<vtkUnstructuredGrid> grid;
};

VtkContours::VtkContours(const TetMesh& mesh, int threads)
    : grid_(std::make_unique<Grid>(Grid{grid_of(mesh)})) {
  vtk::detail::smp::vtkSMPToolsAPI::GetInstance().Initialize(threads);
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

SurfaceMesh vtk_triangles(const TetMesh& mesh, const ModeValue& mode, VtkFilter filter) {
  return triangles_of(*contour(grid_of(mesh), mode.approx(), filter));
}

SurfaceMesh vtk_contour(const TetMesh& mesh, const ModeValue& mode, VtkFilter filter) {
  const auto grid = grid_of(mesh);
  SurfaceMesh surface = triangles_of(*contour(grid, mode.approx(), filter));
  // The filters do not say of which tetrahedron a triangle is.
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(grid);
  if (!surface.triangles.empty()) locator->BuildLocator();
  for (auto& t : surface.triangles) {
    const auto &p = surface.points[as_size(t[0])], &q = surface.points[as_size(t[1])],
               &r = surface.points[as_size(t[2])];
    const Index tet = tet_around((1.0 / 3) * (p + q + r), mesh, *locator);
    surface.tet.push_back(tet);
    if (slope_along(cross(q - p, r - p), mesh, *grid->GetPointData()->GetScalars(), tet) < 0)
      std::swap(t[1], t[2]);
  }
  surface.mode.assign(surface.points.size(), mode.approx());
  surface.component = surface_components(surface);
  return surface;
}

}  // namespace tensortopo
