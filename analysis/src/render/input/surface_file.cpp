// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/input/surface_file.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/read_surface_file.hpp"

namespace tensortopo {
namespace {

vtkSmartPointer<vtkCellArray> cells_of(const IndexLists& lists) {
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> corners;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    corners.assign(lists.points.begin() + static_cast<std::ptrdiff_t>(lists.begin_of(i)),
                   lists.points.begin() + static_cast<std::ptrdiff_t>(lists.ends[i]));
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
  return cells;
}

/// As doubles, which is how they were read.
bool has_exact_integers(const SurfaceArray& array) {
  constexpr double kLargest = 0x1p53;
  return array.is_integer && std::all_of(array.values.begin(), array.values.end(),
                                         [](double v) { return v >= -kLargest && v <= kLargest; });
}

template <class Array>
void add_array(const SurfaceArray& array, std::size_t tuples, vtkDataSetAttributes& data) {
  vtkNew<Array> copy;
  copy->SetName(array.name.c_str());
  copy->SetNumberOfComponents(static_cast<int>(array.components));
  copy->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  std::transform(array.values.begin(), array.values.end(), copy->GetPointer(0),
                 [](double v) { return static_cast<typename Array::ValueType>(v); });
  data.AddArray(copy);
}

void add_arrays(const std::vector<SurfaceArray>& arrays, std::size_t tuples,
                vtkDataSetAttributes& data) {
  for (const SurfaceArray& array : arrays) {
    if (array.components == 0) continue;
    if (has_exact_integers(array))
      add_array<vtkTypeInt64Array>(array, tuples, data);
    else
      add_array<vtkDoubleArray>(array, tuples, data);
  }
}

/// The cells that are asked for, by their place in the list and their first point.
template <class Wanted>
vtkSmartPointer<vtkCellArray> select(vtkCellArray* cells, const Wanted& wanted) {
  const auto selected = vtkSmartPointer<vtkCellArray>::New();
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
    cells->GetCellAtId(i, size, points);
    if (size > 0 && wanted(i, points[0])) {
      selected->InsertNextCell(size, points);
    }
  }
  return selected;
}

vtkSmartPointer<vtkPolyData> part_of(vtkPolyData* all, vtkCellArray* triangles,
                                     vtkCellArray* lines) {
  const auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(all->GetPoints());
  part->GetPointData()->ShallowCopy(all->GetPointData());
  part->SetPolys(triangles);
  part->SetLines(lines);
  vtkNew<vtkCleanPolyData> used;  // drops the points of the others
  used->PointMergingOff();
  used->SetInputData(part);
  used->Update();
  return used->GetOutput();
}

/// Of cells that have a point that is asked for: those that are stable, or of which no array says
/// so; then, marked, the others.
std::vector<std::pair<vtkSmartPointer<vtkPolyData>, bool>> stable_and_other(
    vtkPolyData* all, const std::function<bool(vtkIdType)>& has_point) {
  vtkDataArray* const stable = all->GetCellData()->GetArray("stable");
  const vtkIdType first_line = all->GetNumberOfVerts(),
                  first_triangle = first_line + all->GetNumberOfLines();
  std::vector<std::pair<vtkSmartPointer<vtkPolyData>, bool>> parts;
  for (const bool is_unstable : {false, true}) {
    const auto wanted = [&](vtkIdType first) {
      return [&, first](vtkIdType i, vtkIdType point) {
        const bool faded = stable != nullptr && stable->GetComponent(first + i, 0) == 0;
        return has_point(point) && faded == is_unstable;
      };
    };
    const auto triangles = select(all->GetPolys(), wanted(first_triangle));
    const auto lines = select(all->GetLines(), wanted(first_line));
    if (triangles->GetNumberOfCells() + lines->GetNumberOfCells() > 0)
      parts.emplace_back(part_of(all, triangles, lines), is_unstable);
  }
  return parts;
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& file) {
  if (lower_extension(file) != ".vtp")
    throw IoError(IoError::Kind::invalid, file, "must be a surface in .vtp");
  const SurfaceFile given = read_surface_file(file);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : given.points) points->InsertNextPoint(p.x, p.y, p.z);
  const auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(cells_of(given.lines));
  result->SetPolys(cells_of(given.polygons));
  for (const auto& [name, text] : given.texts) {
    vtkNew<vtkStringArray> array;
    array->SetName(name.c_str());
    array->InsertNextValue(text);
    result->GetFieldData()->AddArray(array);
  }
  add_arrays(given.point_data, given.points.size(), *result->GetPointData());
  if (const SurfaceArray* scalars = given.find_point_data(given.scalars);
      scalars != nullptr && scalars->components == 1)
    result->GetPointData()->SetActiveScalars(given.scalars.c_str());
  if (const SurfaceArray* normals = given.find_point_data(given.normals);
      normals != nullptr && normals->components == 3)
    result->GetPointData()->SetActiveNormals(given.normals.c_str());
  add_arrays(given.cell_data, given.lines.size() + given.polygons.size(), *result->GetCellData());
  return result;
}

std::vector<Sheet> sheets_of(vtkPolyData* all) {
  if (all->GetNumberOfPolys() + all->GetNumberOfLines() == 0) return {};
  vtkPointData* const data = all->GetPointData();
  if (vtkDataArray* const normals = data->GetArray("normal");
      normals != nullptr && normals->GetNumberOfComponents() == 3) {
    data->SetNormals(normals);
  }
  // What tells sheets apart: the first of these that the file has.
  for (const auto& [name, member] :
       {std::pair{"mode", &Sheet::mode}, {"value", &Sheet::value}, {"kind", &Sheet::ridge_kind}}) {
    vtkDataArray* const numbers = data->GetArray(name);
    if (numbers == nullptr) continue;
    std::set<double> values;
    for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
      values.insert(numbers->GetComponent(i, 0));
    std::vector<Sheet> sheets;
    for (const double value : values) {
      const auto has_value = [&](vtkIdType point) {
        return numbers->GetComponent(point, 0) == value;
      };
      for (const auto& [part, is_unstable] : stable_and_other(all, has_value)) {
        sheets.push_back({std::nullopt, part});
        sheets.back().*member = value;
        sheets.back().is_unstable = is_unstable;
      }
    }
    return sheets;
  }
  return {{std::nullopt, all}};
}

}  // namespace tensortopo
