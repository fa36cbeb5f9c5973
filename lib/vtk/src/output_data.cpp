// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "output_data.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <initializer_list>
#include <map>
#include <span>
#include <string>

namespace tensortopo::filters {

namespace {

using Index = SurfaceMesh::Index;

/// Which vertices an output keeps, in order.
struct Kept {
  std::vector<std::size_t> vertices;  ///< those kept
  std::vector<Index> number;          ///< of each vertex; -1 for the others

  explicit Kept(std::size_t count) : number(count, -1) {}
  /// All, or those that cells use.
  template <class Cells>
  Kept(std::size_t count, const Cells& cells, const std::vector<std::size_t>& kept_cells)
      : Kept(count) {
    std::vector<bool> used(count, kept_cells.size() == cells.size());
    if (kept_cells.size() != cells.size())
      for (const std::size_t c : kept_cells)
        for (const Index v : cells[c]) used[as_size(v)] = true;
    for (std::size_t v = 0; v < count; ++v)
      if (used[v]) {
        number[v] = static_cast<Index>(vertices.size());
        vertices.push_back(v);
      }
  }
};

vtkSmartPointer<vtkDoubleArray> numbers(const char* name, const std::vector<double>& values,
                                        const std::vector<std::size_t>& which) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i)
    array->SetValue(static_cast<vtkIdType>(i), values[which[i]]);
  return array;
}

vtkSmartPointer<vtkDoubleArray> vectors(const char* name,
                                        const std::vector<Vector3<double>>& values,
                                        const std::vector<std::size_t>& which) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i) {
    const Vector3<double>& v = values[which[i]];
    array->SetTuple3(static_cast<vtkIdType>(i), v.x, v.y, v.z);
  }
  return array;
}

vtkSmartPointer<vtkPoints> points_of(const std::vector<Vector3<double>>& points,
                                     const std::vector<std::size_t>& which) {
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  result->SetData(vectors("Points", points, which));
  return result;
}

template <class Cells>
vtkSmartPointer<vtkCellArray> cells_of(const Cells& cells, const std::vector<std::size_t>& which,
                                       const Kept& kept) {
  auto result = vtkSmartPointer<vtkCellArray>::New();
  for (const std::size_t c : which) {
    result->InsertNextCell(static_cast<int>(cells[c].size()));
    for (const Index v : cells[c]) result->InsertCellPoint(kept.number[as_size(v)]);
  }
  return result;
}

void add_cell_data(vtkPolyData* output, const std::vector<Index>& tets,
                   const std::vector<Index>& components, const std::vector<std::size_t>& which,
                   const TetMesh& mesh) {
  vtkNew<vtkTypeInt64Array> tet;
  vtkNew<vtkTypeInt32Array> component;
  tet->SetName("tet"), component->SetName("component");
  for (const std::size_t c : which) {
    tet->InsertNextValue(mesh.cell_ids[as_size(tets[c])]);
    component->InsertNextValue(components[c]);
  }
  output->GetCellData()->AddArray(tet);
  output->GetCellData()->AddArray(component);
}

void add_numbers(vtkDataSetAttributes* data, const std::string& name,
                 const std::vector<std::int32_t>& values, const std::vector<std::size_t>& which) {
  vtkNew<vtkTypeInt32Array> array;
  array->SetName(name.c_str());
  for (const std::size_t c : which) array->InsertNextValue(values[c]);
  data->AddArray(array);
}

/// @param values  those of the surface, or of the curves
void add_more(vtkPolyData* output, const std::vector<CellArray>& more,
              std::vector<std::int32_t> CellArray::*values, const std::vector<std::size_t>& cells,
              const std::vector<std::size_t>& vertices) {
  for (const CellArray& array : more)
    if (array.of_points)
      add_numbers(output->GetPointData(), array.name, array.*values, vertices);
    else
      add_numbers(output->GetCellData(), array.name, array.*values, cells);
}

}  // namespace

void fill(vtkPolyData* output, const SurfaceMesh& surface, const TensorGrid& grid,
          const std::vector<CellArray>& more) {
  const auto own = own_cells(grid.piece, surface.tet, 0, surface.tet.size());
  const Kept kept(surface.points.size(), surface.triangles, own);
  const auto& which = kept.vertices;
  output->SetPoints(points_of(surface.points, which));
  output->SetPolys(cells_of(surface.triangles, own, kept));
  vtkPointData* data = output->GetPointData();
  data->AddArray(numbers("mode", surface.mode, which));
  data->AddArray(vectors("medium_eigenvector", surface.medium_eigenvector, which));
  data->AddArray(vectors("dominant_eigenvector", surface.dominant_eigenvector, which));
  data->SetNormals(vectors("normal", surface.normal, which));
  data->AddArray(numbers("residual", surface.residual, which));
  add_cell_data(output, surface.tet, surface.component, own, grid.piece.mesh);
  add_more(output, more, &CellArray::values, own, which);
}

void fill(vtkPolyData* output, const std::vector<WholeSurface>& surfaces) {
  vtkNew<vtkDoubleArray> mode;
  vtkNew<vtkTypeInt64Array> components, euler, loops;
  mode->SetName("surface_mode"), components->SetName("components");
  euler->SetName("euler_characteristic"), loops->SetName("boundary_loops");
  for (const WholeSurface& surface : surfaces) {
    mode->InsertNextValue(surface.mode);
    components->InsertNextValue(surface.components);
    euler->InsertNextValue(surface.euler_characteristic);
    loops->InsertNextValue(surface.boundary_loops);
  }
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{mode, components, euler, loops})
    output->GetFieldData()->AddArray(array);
}

void fill(vtkPolyData* output, const std::vector<WholeCurves>& curves) {
  vtkNew<vtkDoubleArray> mode;
  vtkNew<vtkTypeInt64Array> components, closed;
  mode->SetName("curve_mode"), components->SetName("components");
  closed->SetName("closed_components");
  for (const WholeCurves& kind : curves) {
    mode->InsertNextValue(kind.mode);
    components->InsertNextValue(kind.components);
    closed->InsertNextValue(kind.closed_components);
  }
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{mode, components, closed})
    output->GetFieldData()->AddArray(array);
}

void fill(vtkPolyData* output, const CurveMesh& curves, const TensorGrid& grid,
          const std::vector<CellArray>& more) {
  const auto own = own_cells(grid.piece, curves.tet, 0, curves.tet.size());
  const Kept kept(curves.points.size(), curves.lines, own);
  const auto& which = kept.vertices;
  output->SetPoints(points_of(curves.points, which));
  output->SetLines(cells_of(curves.lines, own, kept));
  vtkPointData* data = output->GetPointData();
  data->AddArray(numbers("mode", curves.mode, which));
  data->AddArray(vectors("dominant_eigenvector", curves.dominant_eigenvector, which));
  data->AddArray(numbers("residual", curves.residual, which));
  data->AddArray(numbers("separation", curves.separation, which));
  add_cell_data(output, curves.tet, curves.component, own, grid.piece.mesh);
  add_more(output, more, &CellArray::line_values, own, which);
}

void fill(vtkUnstructuredGrid* output, const std::vector<LeftOut>& cells, const TensorGrid& grid) {
  const TetMesh& mesh = grid.piece.mesh;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkTypeInt64Array> tet;
  vtkNew<vtkDoubleArray> mode;
  vtkNew<vtkStringArray> reason;
  tet->SetName("tet"), mode->SetName("mode"), reason->SetName("reason");
  std::map<TetMesh::Index, vtkIdType> number;
  output->Allocate(static_cast<vtkIdType>(cells.size()));
  for (const LeftOut& cell : cells) {
    if (grid.piece.is_owned[as_size(cell.tet)] == 0) continue;
    vtkIdType corners[4];
    for (std::size_t i = 0; i < 4; ++i) {
      const TetMesh::Index v = mesh.tets[as_size(cell.tet)][i];
      const auto [it, fresh] = number.try_emplace(v, points->GetNumberOfPoints());
      if (fresh) {
        const Vector3<double>& p = mesh.points[as_size(v)];
        points->InsertNextPoint(p.x, p.y, p.z);
      }
      corners[i] = it->second;
    }
    output->InsertNextCell(VTK_TETRA, 4, corners);
    tet->InsertNextValue(mesh.cell_ids[as_size(cell.tet)]);
    mode->InsertNextValue(cell.mode.approx());
    reason->InsertNextValue(cell.reason.c_str());
  }
  output->SetPoints(points);
  output->GetCellData()->AddArray(tet);
  output->GetCellData()->AddArray(mode);
  output->GetCellData()->AddArray(reason);
}

}  // namespace tensortopo::filters
