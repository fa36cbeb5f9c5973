// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "conformance/triangle_search.hpp"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>

namespace tensortopo {

struct TriangleSearch::Locator {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkStaticCellLocator> locator;
  // VTK's search writes into the cell that it is given: each thread has its own.
  tbb::enumerable_thread_specific<vtkNew<vtkGenericCell>> cells;
  vtkNew<vtkIdList> found;
};

TriangleSearch::TriangleSearch(const SurfaceMesh& surface) : locator_(std::make_unique<Locator>()) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : surface.points) points->InsertNextPoint(p.x, p.y, p.z);
  vtkNew<vtkCellArray> cells;
  for (const auto& t : surface.triangles) {
    const vtkIdType corners[3]{t[0], t[1], t[2]};
    cells->InsertNextCell(3, corners);
  }
  locator_->data->SetPoints(points);
  locator_->data->SetPolys(cells);
  locator_->locator->SetDataSet(locator_->data);
  locator_->locator->BuildLocator();
}

TriangleSearch::~TriangleSearch() = default;

TriangleSearch::Nearest TriangleSearch::nearest(const Vector3<double>& p) const {
  const double x[3]{p.x, p.y, p.z};
  double closest[3], squared = 0;
  vtkIdType cell = -1;
  int sub = 0;
  locator_->locator->FindClosestPoint(x, closest, locator_->cells.local(), cell, sub, squared);
  return {static_cast<SurfaceMesh::Index>(cell), std::sqrt(squared)};
}

std::vector<SurfaceMesh::Index> TriangleSearch::near_box(const Vector3<double>& low,
                                                         const Vector3<double>& high) const {
  double box[6]{low.x, high.x, low.y, high.y, low.z, high.z};
  locator_->found->Reset();
  locator_->locator->FindCellsWithinBounds(box, locator_->found);
  std::vector<SurfaceMesh::Index> result;
  for (vtkIdType i = 0; i < locator_->found->GetNumberOfIds(); ++i)
    result.push_back(static_cast<SurfaceMesh::Index>(locator_->found->GetId(i)));
  std::sort(result.begin(), result.end());
  return result;
}

double distance_to_triangle(const Vector3<double>& p, const Vector3<double>& a,
                            const Vector3<double>& b, const Vector3<double>& c) {
  const auto to_segment = [&](const Vector3<double>& u, const Vector3<double>& v) {
    const auto d = v - u;
    const double length = dot(d, d);
    const double t = length > 0 ? std::clamp(dot(p - u, d) / length, 0.0, 1.0) : 0;
    const auto gap = p - u - t * d;
    return dot(gap, gap);
  };
  const auto n = cross(b - a, c - a);
  const double area = dot(n, n);
  // Above the inside, on the same side of all three edges, the plane is nearest.
  if (area > 0 && dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
      dot(cross(a - c, p - c), n) >= 0)
    return std::abs(dot(p - a, n)) / std::sqrt(area);
  return std::sqrt(std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)}));
}

}  // namespace tensortopo
