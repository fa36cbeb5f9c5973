// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/input/surface_input.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "render/input/surface_file.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"

namespace tensortopo {
namespace {

constexpr double kSlack = 1e-6;  ///< of barycentric coordinates; coordinates are rounded

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw IoError(IoError::Kind::invalid, file, what);
}

Vector3<double> vector_at(vtkDataArray* array, vtkIdType i) {
  return {array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2)};
}

/// The least barycentric coordinate of a point.
double depth_in(const TetMesh& mesh, SurfaceMesh::Index tet, const Vector3<double>& point) {
  const auto& t = mesh.tets[as_size(tet)];
  const auto& first = mesh.points[as_size(t[0])];
  const Vector3<double> e1 = mesh.points[as_size(t[1])] - first,
                        e2 = mesh.points[as_size(t[2])] - first,
                        e3 = mesh.points[as_size(t[3])] - first, x = point - first;
  const double volume = dot(e1, cross(e2, e3));
  const double a = dot(x, cross(e2, e3)) / volume, b = dot(e1, cross(x, e3)) / volume,
               c = dot(e1, cross(e2, x)) / volume;
  return std::min({a, b, c, 1 - a - b - c});
}

/// Why a surface is not of this field, for those whose file says of which one it is; else empty.
std::string foreign_to(const FieldOrigin& surface, const FieldOrigin& field) {
  if (!surface.sha256.empty() && surface.sha256 != field.sha256)
    return fmt::format(
        "was extracted from another field than that of --mesh (its input_sha256 is "
        "{:.12}..., that of the file is {:.12}...); extract it from this file",
        surface.sha256, field.sha256);
  if (!surface.tensor.empty() && surface.tensor != field.tensor)
    return fmt::format("was extracted from the tensor `{}`, not `{}` (--tensor)", surface.tensor,
                       field.tensor);
  return "";
}

}  // namespace

FieldOrigin origin_of(vtkPolyData& data) {
  const auto text_of = [&](const char* name) {
    auto* const array = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray(name));
    return array != nullptr && array->GetNumberOfValues() == 1 ? std::string(array->GetValue(0))
                                                               : std::string();
  };
  return {text_of("input_sha256"), text_of("tensor")};
}

SurfaceInput read_surface(const std::filesystem::path& file) {
  if (lower_extension(file) != ".vtp") fail(file, "must be a surface in .vtp");
  SurfaceInput input;
  input.file = read_poly_data(file);
  vtkPolyData& data = *input.file;
  SurfaceMesh& surface = input.surface;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    std::array<double, 3> p;
    data.GetPoint(i, p.data());
    surface.points.push_back({p[0], p[1], p[2]});
  }
  vtkCellArray* const polygons = data.GetPolys();
  if (polygons->GetNumberOfCells() == 0 && data.GetNumberOfPoints() > 0)
    fail(file, "holds no triangles");
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i) {
    polygons->GetCellAtId(i, size, corners);
    if (size != 3) fail(file, fmt::format("cell {} is no triangle", i));
    using Index = SurfaceMesh::Index;
    for (int k = 0; k < 3; ++k)
      if (corners[k] < 0 || corners[k] >= data.GetNumberOfPoints())
        fail(file, fmt::format("triangle {} names a point that does not exist", i));
    surface.triangles.push_back({static_cast<Index>(corners[0]), static_cast<Index>(corners[1]),
                                 static_cast<Index>(corners[2])});
  }
  const vtkIdType count = data.GetNumberOfPoints();
  if (vtkDataArray* const normals = data.GetPointData()->GetArray("normal");
      normals != nullptr && normals->GetNumberOfComponents() == 3)
    for (vtkIdType i = 0; i < count; ++i) surface.normal.push_back(vector_at(normals, i));
  if (vtkDataArray* const modes = data.GetPointData()->GetArray("mode"))
    for (vtkIdType i = 0; i < count; ++i) surface.mode.push_back(modes->GetComponent(i, 0));
  if (vtkDataArray* const values = data.GetPointData()->GetArray("value"))
    for (vtkIdType i = 0; i < count; ++i) surface.value.push_back(values->GetComponent(i, 0));
  // Cells come as vertices, lines, polygons.
  const vtkIdType before = data.GetNumberOfVerts() + data.GetNumberOfLines();
  if (vtkDataArray* const tets = data.GetCellData()->GetArray("tet"))
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
      input.cell_ids.push_back(
          static_cast<std::int64_t>(tets->GetComponent(before + static_cast<vtkIdType>(i), 0)));
  return input;
}

void locate_in_mesh(SurfaceInput& input, const TetMesh& mesh, const FieldOrigin& field,
                    const std::filesystem::path& file) {
  if (const std::string why = foreign_to(origin_of(*input.file), field); !why.empty())
    fail(file, why);
  if (input.cell_ids.empty() && !input.surface.triangles.empty())
    fail(file, "has no cell data 'tet'");
  std::unordered_map<std::int64_t, SurfaceMesh::Index> index;
  for (std::size_t i = 0; i < mesh.cell_ids.size(); ++i)
    index.emplace(mesh.cell_ids[i], static_cast<SurfaceMesh::Index>(i));
  SurfaceMesh& surface = input.surface;
  surface.tet.clear();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto tet = index.find(input.cell_ids[i]);
    if (tet == index.end())
      fail(file, fmt::format("is not of this mesh (it has no cell {})", input.cell_ids[i]));
    for (const auto v : surface.triangles[i])
      if (!(depth_in(mesh, tet->second, surface.points[as_size(v)]) > -kSlack))
        fail(file, fmt::format("is not of this mesh (triangle {} is not in cell {})", i,
                               input.cell_ids[i]));
    surface.tet.push_back(tet->second);
  }
}

void require_modes(const SurfaceInput& input, const std::filesystem::path& file) {
  if (!input.surface.value.empty())
    fail(file, "is a surface of another invariant; the field's curvature is known for modes only");
}

}  // namespace tensortopo
