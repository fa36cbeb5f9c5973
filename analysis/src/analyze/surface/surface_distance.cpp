// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <cmath>

#include "analyze/surface/surface_quality.hpp"

namespace tensortopo {
namespace {

vtkNew<vtkPolyData> poly_data(const SurfaceMesh& surface) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : surface.points) points->InsertNextPoint(p.x, p.y, p.z);
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : surface.triangles) triangles->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

}  // namespace

SampledDistance sampled_distance(const SurfaceMesh& from, const SurfaceMesh& to) {
  if (to.triangles.empty()) return {};
  const auto target = poly_data(to);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(target);
  locator->BuildLocator();
  SampledDistance result;
  const auto look = [&](const Vector3<double>& p) {
    const double x[3] = {p.x, p.y, p.z};
    double nearest[3], squared = 0;
    vtkIdType cell = 0;
    int part = 0;
    locator->FindClosestPoint(x, nearest, cell, part, squared);
    const double distance = std::sqrt(squared);
    ++result.samples;
    result.mean += distance;
    result.root_mean_square += squared;
    if (distance > result.largest || result.samples == 1) {
      result.largest = distance;
      result.where = p;
    }
  };
  std::vector<char> is_used(from.points.size(), 0);
  for (const auto& t : from.triangles) {
    Vector3<double> middle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &p = from.points[as_size(t[i])], &q = from.points[as_size(t[(i + 1) % 3])];
      is_used[as_size(t[i])] = 1;
      middle += (1.0 / 3) * p;
      // Of the two triangles at an edge the one that runs upwards; one on the boundary may run
      // downwards.
      if (t[i] < t[(i + 1) % 3]) look(0.5 * (p + q));
    }
    look(middle);
  }
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v] != 0) look(from.points[v]);
  if (result.samples > 0) {
    result.mean /= static_cast<double>(result.samples);
    result.root_mean_square =
        std::sqrt(result.root_mean_square / static_cast<double>(result.samples));
  }
  return result;
}

}  // namespace tensortopo
