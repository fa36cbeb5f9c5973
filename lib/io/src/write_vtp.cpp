// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

#include "surface_formats.hpp"
#include "vtk_arrays.hpp"

namespace tensortopo::detail {
namespace {

using Arrays = std::vector<std::string>;

void add(vtkDataSetAttributes& data, Arrays& names, const char* name,
         const std::vector<Vector3<double>>& values) {
  if (values.empty()) return;
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
void add(vtkDataSetAttributes& data, Arrays& names, const char* name, const Values& values,
         const Convert& convert) {
  if (values.empty()) return;
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    array->SetValue(static_cast<vtkIdType>(i), convert(values[i]));
  data.AddArray(array);
  names.emplace_back(name);
}

}  // namespace

std::string to_vtp(const SurfaceMesh& surface, const TetMesh& mesh, Arrays& names) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtk_points(surface.points));
  data->SetPolys(vtk_cells(surface.triangles));

  const auto same = [](auto value) { return value; };
  vtkDataSetAttributes& points = *data->GetPointData();
  add<vtkDoubleArray>(points, names, "mode", surface.mode, same);
  add(points, names, "medium_eigenvector", surface.medium_eigenvector);
  add(points, names, "dominant_eigenvector", surface.dominant_eigenvector);
  add(points, names, "normal", surface.normal);
  add<vtkDoubleArray>(points, names, "residual", surface.residual, same);
  vtkDataSetAttributes& cells = *data->GetCellData();
  add<vtkTypeInt64Array>(cells, names, "tet", surface.tet, [&](SurfaceMesh::Index t) {
    return mesh.cell_ids[static_cast<std::size_t>(t)];
  });
  add<vtkTypeInt32Array>(cells, names, "component", surface.component, same);

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  return run_vtk_writer(*writer);
}

}  // namespace tensortopo::detail
