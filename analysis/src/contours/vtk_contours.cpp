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
#include <array>
#include <limits>
#include <utility>

#include "extract/level/tet_geometry.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {
namespace {

using Index = SurfaceMesh::Index;

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

TetGeometry geometry(const TetMesh& mesh, Index tet) {
  std::array<Vector3<double>, 4> points;
  for (std::size_t i = 0; i < 4; ++i) points[i] = mesh.points[as_size(mesh.tets[as_size(tet)][i])];
  return {points, {}};
}

/// Slope along a direction of the function that is linear between the values at the vertices.
double slope_along(const Vector3<double>& direction, const TetMesh& mesh, vtkDataArray& values,
                   Index tet) {
  const auto space = geometry(mesh, tet);
  double slope = 0;
  for (std::size_t i = 0; i < 4; ++i)
    slope +=
        values.GetTuple1(mesh.tets[as_size(tet)][i]) * dot(direction, space.weight_gradient(i));
  return slope;
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
    const auto space = geometry(mesh, t);
    const double least = std::min(
        {space.weight(0, x), space.weight(1, x), space.weight(2, x), space.weight(3, x)});
    if (least > most) most = least, best = t;
  }
  return best;
}

/// @param in_order  by one thread, as several change the order of what
///                  vtkContour3DLinearGrid makes
vtkSmartPointer<vtkPolyData> contour(vtkUnstructuredGrid* grid, std::span<const double> values,
                                     VtkFilter filter, bool in_order) {
  const auto run = [&](auto& contour) -> vtkSmartPointer<vtkPolyData> {
    contour.SetInputData(grid);
    for (std::size_t i = 0; i < values.size(); ++i)
      contour.SetValue(static_cast<int>(i), values[i]);
    contour.Update();
    return vtkPolyData::SafeDownCast(contour.GetOutputDataObject(0));
  };
  if (filter == VtkFilter::contour_grid) {
    vtkNew<vtkContourGrid> contour;
    contour->ComputeNormalsOff();
    return run(*contour);
  }
  vtkNew<vtkContour3DLinearGrid> contour;
  contour->MergePointsOn();
  contour->SetSequentialProcessing(in_order);
  return run(*contour);
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

vtkSmartPointer<vtkPolyData> contour_in_order(vtkUnstructuredGrid* grid, const ModeValue& mode,
                                              VtkFilter filter) {
  return contour(grid, std::array{mode.approx()}, filter, true);
}

std::size_t count(vtkUnstructuredGrid* grid, std::span<const double> values, VtkFilter filter) {
  return static_cast<std::size_t>(contour(grid, values, filter, false)->GetNumberOfPolys());
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
  return count(grid_->grid, values, VtkFilter::contour_grid);
}

std::size_t VtkContours::contour_3d_linear_grid(std::span<const double> values) {
  return count(grid_->grid, values, VtkFilter::contour_3d_linear_grid);
}

SurfaceMesh vtk_triangles(const TetMesh& mesh, const ModeValue& mode, VtkFilter filter) {
  return triangles_of(*contour_in_order(grid_of(mesh), mode, filter));
}

SurfaceMesh vtk_contour(const TetMesh& mesh, const ModeValue& mode, VtkFilter filter) {
  const auto grid = grid_of(mesh);
  SurfaceMesh surface = triangles_of(*contour_in_order(grid, mode, filter));
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
