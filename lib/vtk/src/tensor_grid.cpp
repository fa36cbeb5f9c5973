// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensor_grid.hpp"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "tensortopo/mesh/validate.hpp"
#include "tensortopo/tensor/component_names.hpp"

namespace tensortopo::filters {

namespace {

/// The order of an array's components: what their names say, else what is chosen, else VTK's.
ComponentOrder order_of(vtkDataArray* tensors, std::optional<ComponentOrder> chosen) {
  std::vector<std::string> names;
  for (int i = 0; i < tensors->GetNumberOfComponents(); ++i) {
    const char* name = tensors->GetComponentName(i);
    names.emplace_back(name != nullptr ? name : "");
  }
  const char* array = tensors->GetName();
  return decide_order(names, names.size(), chosen,
                      {array != nullptr ? array : "", "the property ComponentOrder"})
      .order;
}

/// What ComponentOrder of a filter says: the first value is none.
constexpr std::array<ComponentOrder, 5> kOrders{ComponentOrder::vtk, ComponentOrder::voigt,
                                                ComponentOrder::abaqus, ComponentOrder::nifti,
                                                ComponentOrder::fsl};

/// The mean of two entries of a matrix, without overflow; exact where they are equal.
double mean(double a, double b) { return a == b ? a : a / 2 + b / 2; }

SymmetricTensor<double> of_matrix(const std::array<double, 9>& v, vtkIdType point) {
  // Largest asymmetry, of the norm, that is taken for rounding in the data.
  constexpr double tolerance = 1e-9;
  double square = 0, gap = 0;
  for (const double x : v) square += x * x;
  for (const auto& [i, j] : {std::pair{1u, 3u}, {2u, 6u}, {5u, 7u}})
    gap = std::max(gap, std::abs(v[i] - v[j]));
  if (gap > tolerance * std::sqrt(square))
    throw std::runtime_error("the tensor of point " + std::to_string(point) + " is not symmetric");
  return {v[0], v[4], v[8], mean(v[1], v[3]), mean(v[5], v[7]), mean(v[2], v[6])};
}

/// An id of an array of whole numbers of any type.
vtkIdType id_at(vtkDataArray* ids, vtkIdType i) {
  if (auto* array = vtkIdTypeArray::SafeDownCast(ids)) return array->GetValue(i);
  if (auto* array = vtkTypeInt64Array::SafeDownCast(ids)) return array->GetValue(i);
  return static_cast<vtkIdType>(ids->GetComponent(i, 0));
}

/// Numbers 0, 1, ... in the order of global ids, if there are any.
std::vector<vtkIdType> numbers(vtkIdType count, vtkDataSetAttributes* data) {
  std::vector<vtkIdType> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), vtkIdType{0});
  if (vtkDataArray* ids = data->GetGlobalIds())
    std::stable_sort(order.begin(), order.end(),
                     [&](vtkIdType a, vtkIdType b) { return id_at(ids, a) < id_at(ids, b); });
  return order;
}

/// Points of one global id, place and tensor are one vertex: so are those of pieces that were read
/// into one grid.
/// @param place  of the library's components among six
/// @return of each point, its vertex
std::vector<TetMesh::Index> read_points(vtkUnstructuredGrid* grid, vtkDataArray* tensors,
                                        const std::array<std::uint8_t, 6>& place,
                                        MeshPiece& piece) {
  const vtkIdType n = grid->GetNumberOfPoints();
  std::vector<TetMesh::Index> vertex(static_cast<std::size_t>(n));
  vtkDataArray* ids = grid->GetPointData()->GetGlobalIds();
  TetMesh& mesh = piece.mesh;
  for (const vtkIdType point : numbers(n, grid->GetPointData())) {
    double p[3];
    grid->GetPoint(point, p);
    const Vector3<double> at{p[0], p[1], p[2]};
    std::array<double, 9> v{};
    tensors->GetTuple(point, v.data());
    const auto tensor = tensors->GetNumberOfComponents() == 9
                            ? of_matrix(v, point)
                            : SymmetricTensor<double>{v[place[0]], v[place[1]], v[place[2]],
                                                      v[place[3]], v[place[4]], v[place[5]]};
    const vtkIdType id = ids != nullptr ? id_at(ids, point) : point;
    std::size_t same = mesh.points.size();
    for (std::size_t i = same; i > 0 && piece.vertex_ids[i - 1] == id; --i)
      if (mesh.points[i - 1] == at && mesh.tensors[i - 1] == tensor) same = i - 1;
    vertex[as_size(point)] = static_cast<TetMesh::Index>(same);
    if (same < mesh.points.size()) continue;
    piece.vertex_ids.push_back(id);
    mesh.points.push_back(at), mesh.tensors.push_back(tensor);
  }
  return vertex;
}

bool is_flat(int type) {
  return type <= VTK_QUAD || (type >= VTK_QUADRATIC_EDGE && type <= VTK_QUADRATIC_QUAD);
}

}  // namespace

vtkDataArray* only_tensors(vtkUnstructuredGrid* grid) {
  vtkDataArray* found = nullptr;
  vtkPointData* data = grid->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data->GetArray(i);
    if (array == nullptr) continue;
    if (array->GetNumberOfComponents() != 6 && array->GetNumberOfComponents() != 9) continue;
    if (found != nullptr)
      throw std::runtime_error("several point arrays have 6 or 9 components; choose the tensors");
    found = array;
  }
  if (found == nullptr)
    throw std::runtime_error("no point array has the 6 or 9 components of a tensor");
  return found;
}

TensorGrid tensor_grid(vtkUnstructuredGrid* grid, vtkDataArray* tensors, int order) {
  const int width = tensors->GetNumberOfComponents();
  if (width != 6 && width != 9)
    throw std::runtime_error("the tensors have " + std::to_string(width) +
                             " components, not 6 or 9");
  if (tensors->GetNumberOfTuples() != grid->GetNumberOfPoints())
    throw std::runtime_error("the tensors are not one for each point");
  TensorGrid result;
  result.grid = grid;
  result.tensor = tensors->GetName() != nullptr ? tensors->GetName() : "";
  std::optional<ComponentOrder> chosen;
  if (width == 6 && order > 0) chosen = kOrders[static_cast<std::size_t>(order - 1)];
  const ComponentOrder taken = order_of(tensors, chosen);
  result.components = name_of(taken);

  TetMesh& mesh = result.piece.mesh;
  const auto local = read_points(grid, tensors, places_in(taken), result.piece);
  vtkDataArray* point_ids = grid->GetPointData()->GetGlobalIds();

  vtkDataArray* ids = grid->GetCellData()->GetGlobalIds();
  vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
  std::map<int, std::size_t> others;
  for (const vtkIdType c : numbers(grid->GetNumberOfCells(), grid->GetCellData())) {
    const int type = grid->GetCellType(c);
    if (type != VTK_TETRA) {
      if (!is_flat(type)) ++others[type];
      continue;
    }
    vtkIdType count = 0;
    const vtkIdType* v = nullptr;
    grid->GetCellPoints(c, count, v);
    mesh.tets.push_back(
        {local[as_size(v[0])], local[as_size(v[1])], local[as_size(v[2])], local[as_size(v[3])]});
    mesh.cell_ids.push_back(ids != nullptr ? id_at(ids, c) : c);
    result.cells.push_back(c);
    const bool is_ghost =
        ghosts != nullptr && (ghosts->GetValue(c) & vtkDataSetAttributes::DUPLICATECELL) != 0;
    result.piece.is_owned.push_back(is_ghost ? 0 : 1);
  }
  // Cells are in the order of their ids.
  const auto twice = std::adjacent_find(mesh.cell_ids.begin(), mesh.cell_ids.end());
  if (ghosts != nullptr && twice != mesh.cell_ids.end())
    throw std::runtime_error("two cells have the global id " + std::to_string(*twice) +
                             ": two ranks own it, or the ids are not global");
  if (!others.empty())
    throw std::runtime_error("has cells of VTK's type " + std::to_string(others.begin()->first) +
                             " (" + std::to_string(others.begin()->second) +
                             "), no linear tetrahedra; apply Tetrahedralize first");
  result.has_ids = point_ids != nullptr && ids != nullptr;
  result.piece.whole_tets = static_cast<std::int64_t>(mesh.tets.size());
  repair_orientation(mesh);
  if (const auto defects = validate(mesh); !defects.empty())
    throw std::runtime_error(defects.front().text);
  return result;
}

std::vector<std::size_t> own_cells(const MeshPiece& piece, const std::vector<TetMesh::Index>& tets,
                                   std::size_t first, std::size_t count) {
  std::vector<std::size_t> own;
  for (std::size_t i = first; i < first + count; ++i)
    if (piece.is_owned[as_size(tets[i])] != 0) own.push_back(i);
  return own;
}

}  // namespace tensortopo::filters
