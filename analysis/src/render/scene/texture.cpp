// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene/texture.hpp"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <string>
#include <vector>

#include "render/scene/fine_surface.hpp"
#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {
namespace {

constexpr const char* kLines = "line_field";
constexpr std::size_t kMostVertices = 3000000;
// Longest edge of the fine triangles, in grains.
constexpr double kEdge = 1.25;

}  // namespace

Texture parse_texture(std::string_view text) {
  if (text == "major") return Texture::major;
  if (text == "minor") return Texture::minor;
  if (text == "dominant") return Texture::dominant;
  throw UsageError("--texture " + std::string(text) + ": must be major, minor or dominant");
}

void set_line_field(vtkPolyData& shape, const LineField& field) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(kLines);
  array->SetNumberOfComponents(6);
  for (const auto& t : field) array->InsertNextTuple6(t.xx, t.yy, t.zz, t.xy, t.yz, t.xz);
  shape.GetPointData()->AddArray(array);
}

LineField line_field_of(vtkPolyData& shape) {
  LineField field;
  vtkDataArray* const array = shape.GetPointData()->GetArray(kLines);
  if (array == nullptr) return field;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    double t[6];
    array->GetTuple(i, t);
    field.push_back({t[0], t[1], t[2], t[3], t[4], t[5]});
  }
  return field;
}

SurfaceMesh surface_of(vtkPolyData& shape) {
  SurfaceMesh surface;
  vtkDataArray* const normals = shape.GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < shape.GetNumberOfPoints(); ++i) {
    double p[3];
    shape.GetPoint(i, p);
    surface.points.push_back({p[0], p[1], p[2]});
    if (normals == nullptr) continue;
    normals->GetTuple(i, p);
    surface.normal.push_back({p[0], p[1], p[2]});
  }
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType i = 0; i < shape.GetPolys()->GetNumberOfCells(); ++i) {
    shape.GetPolys()->GetCellAtId(i, size, ids);
    for (vtkIdType k = 2; k < size; ++k) {
      using Index = SurfaceMesh::Index;
      surface.triangles.push_back(
          {static_cast<Index>(ids[0]), static_cast<Index>(ids[k - 1]), static_cast<Index>(ids[k])});
    }
  }
  return surface;
}

Colour shaded(const Colour& colour, double value) {
  return value < 0.5 ? mix(colour, kInk, 1.5 * (0.5 - value))
                     : mix(colour, kWhite, 1.3 * (value - 0.5));
}

vtkSmartPointer<vtkPolyData> textured(vtkPolyData& shape, const Colour& colour, double cell) {
  const SurfaceMesh surface = surface_of(shape);
  const FineSurface fine = fine_surface(surface, kEdge * cell, kMostVertices);
  LicOptions options;
  options.cell = cell;
  const std::vector<double> values =
      stretched(line_integral_convolution(surface, line_field_of(shape), fine.vertices, options));

  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < fine.vertices.size(); ++i) {
    const SurfacePlace& place = fine.vertices[i];
    points->InsertNextPoint(place.point.x, place.point.y, place.point.z);
    const Colour c = shaded(colour, values[i]);
    colours->InsertNextTuple3(std::round(255 * c[0]), std::round(255 * c[1]),
                              std::round(255 * c[2]));
    if (surface.normal.empty()) continue;
    Vector3<double> normal{};
    if (place.triangle >= 0)
      for (std::size_t k = 0; k < 3; ++k)
        normal += fine.weights[i][k] *
                  surface.normal[as_size(surface.triangles[as_size(place.triangle)][k])];
    normals->InsertNextTuple3(normal.x, normal.y, normal.z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : fine.triangles) {
    const vtkIdType ids[3]{t[0], t[1], t[2]};
    triangles->InsertNextCell(3, ids);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(triangles);
  result->GetPointData()->SetScalars(colours);
  if (!surface.normal.empty()) result->GetPointData()->SetNormals(normals);
  return result;
}

}  // namespace tensortopo
