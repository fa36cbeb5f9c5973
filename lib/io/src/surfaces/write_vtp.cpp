// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <utility>

#include "surfaces/surface_formats.hpp"
#include "vtk/vtk_arrays.hpp"

namespace tensortopo::detail {
namespace {

using Arrays = std::vector<std::string>;

// Without values an array is written only if it is `expected`.
void add(vtkDataSetAttributes& data, Arrays& names, const char* name, bool expected,
         const std::vector<Vector3<double>>& values) {
  if (values.empty() && !expected) return;
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  double* out = array->GetPointer(0);
  for (const auto& v : values) *out++ = v.x, *out++ = v.y, *out++ = v.z;
  data.AddArray(array);
  names.emplace_back(name);
}

template <class Array, class Values, class Convert>
void add(vtkDataSetAttributes& data, Arrays& names, const char* name, bool expected,
         const Values& values, const Convert& convert) {
  if (values.empty() && !expected) return;
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    array->SetValue(static_cast<vtkIdType>(i), convert(values[i]));
  data.AddArray(array);
  names.emplace_back(name);
}

/// One array for the points of surface and curves: zero where only the other kind has values.
template <class Value>
std::vector<Value> joined(const std::vector<Value>& of_surface, std::size_t surface_points,
                          const std::vector<Value>& of_curves, std::size_t curve_points) {
  if (of_surface.empty() && of_curves.empty()) return {};
  std::vector<Value> result = of_surface;
  result.resize(surface_points);
  result.insert(result.end(), of_curves.begin(), of_curves.end());
  result.resize(surface_points + curve_points);
  return result;
}

template <class Value>
std::vector<Value> chain(std::vector<Value> first, const std::vector<Value>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Components of the curves are numbered after those of the surface.
std::vector<SurfaceMesh::Index> components(const SurfaceMesh& surface, const CurveMesh& curves) {
  SurfaceMesh::Index first = 0;
  for (const auto c : surface.component) first = std::max(first, c + 1);
  std::vector<SurfaceMesh::Index> result;
  for (const auto c : curves.component) result.push_back(first + c);
  return chain(std::move(result), surface.component);
}

}  // namespace

std::string to_vtp(const SurfaceMesh& surface, const CurveMesh& curves, const TetMesh& mesh,
                   const OutputKinds& kinds, const std::vector<FileNote>& notes, Arrays& names) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtk_points(chain(surface.points, curves.points)));
  data->SetPolys(vtk_cells(surface.triangles));
  if (!curves.lines.empty()) data->SetLines(vtk_lines(curves.lines, surface.points.size()));

  const auto same = [](auto value) { return value; };
  const std::size_t before = surface.points.size(), after = curves.points.size();
  const auto of_both = [&]<class Value>(const std::vector<Value>& of_surface,
                                        const std::vector<Value>& of_curves) {
    return joined(of_surface, before, of_curves, after);
  };
  const bool is_empty = before + after == 0;
  const bool of_modes = is_empty && kinds.mode_surfaces,
             of_values = is_empty && kinds.invariant_surfaces,
             of_curves = is_empty && kinds.degenerate_curves;
  const bool of_any = of_modes || of_values || of_curves;
  vtkDataSetAttributes& points = *data->GetPointData();
  add<vtkDoubleArray>(points, names, "mode", of_modes || of_curves,
                      of_both(surface.mode, curves.mode), same);
  add<vtkDoubleArray>(points, names, "value", of_values, of_both(surface.value, {}), same);
  add(points, names, "medium_eigenvector", of_modes, of_both(surface.medium_eigenvector, {}));
  add(points, names, "dominant_eigenvector", of_modes || of_curves,
      of_both(surface.dominant_eigenvector, curves.dominant_eigenvector));
  add(points, names, "normal", of_modes || of_values, of_both(surface.normal, {}));
  add<vtkDoubleArray>(points, names, "separation", of_curves,
                      joined<double>({}, before, curves.separation, after), same);
  add<vtkDoubleArray>(points, names, "residual", of_any, of_both(surface.residual, curves.residual),
                      same);
  vtkDataSetAttributes& cells = *data->GetCellData();
  add<vtkTypeInt64Array>(
      cells, names, "tet", of_any, chain(curves.tet, surface.tet),
      [&](SurfaceMesh::Index t) { return mesh.cell_ids[static_cast<std::size_t>(t)]; });
  add<vtkTypeInt32Array>(cells, names, "component", of_any, components(surface, curves), same);

  for (const char* const name : {"mode", "value"})
    if (points.HasArray(name)) points.SetActiveScalars(name);
  if (points.HasArray("normal")) points.SetActiveNormals("normal");
  for (const FileNote& note : notes) {
    vtkNew<vtkStringArray> text;
    text->SetName(note.name.c_str());
    text->InsertNextValue(note.text);
    data->GetFieldData()->AddArray(text);
  }

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  return run_vtk_writer(*writer);
}

}  // namespace tensortopo::detail
