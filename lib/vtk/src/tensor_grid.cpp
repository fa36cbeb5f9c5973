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
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::filters {

namespace {

using Components = std::array<const char*, 6>;
constexpr Components kVtk{"xx", "yy", "zz", "xy", "yz", "xz"};
constexpr std::array<Components, 5> kOrders{{kVtk,
                                             {"xx", "yy", "zz", "yz", "xz", "xy"},
                                             {"xx", "yy", "zz", "xy", "xz", "yz"},
                                             {"xx", "xy", "yy", "xz", "yz", "zz"},
                                             {"xx", "xy", "xz", "yy", "yz", "zz"}}};
constexpr std::array<const char*, 5> kNames{"vtk", "voigt", "abaqus", "nifti", "fsl"};

/// The order that the array's component names say, if all six have names.
int named_order(vtkDataArray* tensors) {
  std::array<std::string, 6> names;
  for (int i = 0; i < 6; ++i) {
    const char* name = tensors->GetComponentName(i);
    if (name == nullptr || std::string(name).size() < 2) return -1;
    std::string end(name);
    end = end.substr(end.size() - 2);
    for (char& c : end) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    std::sort(end.begin(), end.end());
    names[static_cast<std::size_t>(i)] = end;
  }
  for (std::size_t k = 0; k < kOrders.size(); ++k)
    if (std::equal(names.begin(), names.end(), kOrders[k].begin())) return static_cast<int>(k);
  throw std::runtime_error("the tensors' components have names, but no order that is known: " +
                           names[0] + " " + names[1] + " ...; choose an order of components");
}

/// Where each of VTK's components is among the array's six.
std::array<std::size_t, 6> places(std::size_t order) {
  std::array<std::size_t, 6> place{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      if (std::string(kVtk[i]) == kOrders[order][j]) place[i] = j;
  return place;
}

/// The mean of two entries of a matrix, without overflow; exact where they are equal.
double mean(double a, double b) { return a == b ? a : a / 2 + b / 2; }

SymmetricTensor<double> of_matrix(const std::array<double, 9>& v, vtkIdType point) {
  // Largest asymmetry, of the norm, that is taken for rounding by whoever wrote the tensors.
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
    std::stable_sort(order.begin(), order.end(), [&](vtkIdType a, vtkIdType b) {
      return id_at(ids, a) < id_at(ids, b);
    });
  return order;
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
  std::array<std::size_t, 6> place{};
  if (width == 6) {
    const int named = named_order(tensors);
    if (order > 0 && named >= 0 && named != order - 1)
      throw std::runtime_error(std::string("the components' names say the order ") +
                               kNames[static_cast<std::size_t>(named)] +
                               ", another one is chosen");
    const auto chosen = static_cast<std::size_t>(order > 0 ? order - 1 : std::max(named, 0));
    place = places(chosen);
    result.components = kNames[chosen];
  } else {
    result.components = "full";
  }

  TetMesh& mesh = result.mesh;
  const vtkIdType n = grid->GetNumberOfPoints();
  const auto points = numbers(n, grid->GetPointData());
  std::vector<TetMesh::Index> local(points.size());
  mesh.points.resize(points.size()), mesh.tensors.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    local[as_size(points[i])] = static_cast<TetMesh::Index>(i);
    double p[3];
    grid->GetPoint(points[i], p);
    mesh.points[i] = {p[0], p[1], p[2]};
    std::array<double, 9> v{};
    tensors->GetTuple(points[i], v.data());
    mesh.tensors[i] = width == 9
                          ? of_matrix(v, points[i])
                          : SymmetricTensor<double>{v[place[0]], v[place[1]], v[place[2]],
                                                    v[place[3]], v[place[4]], v[place[5]]};
  }

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
    mesh.tets.push_back({local[as_size(v[0])], local[as_size(v[1])], local[as_size(v[2])],
                         local[as_size(v[3])]});
    mesh.cell_ids.push_back(ids != nullptr ? id_at(ids, c) : c);
    result.cells.push_back(c);
    result.is_ghost.push_back(
        ghosts != nullptr && (ghosts->GetValue(c) & vtkDataSetAttributes::DUPLICATECELL) != 0);
  }
  if (!others.empty())
    throw std::runtime_error(std::to_string(others.begin()->second) + " cells of VTK's type " +
                             std::to_string(others.begin()->first) +
                             " are no linear tetrahedra; apply Tetrahedralize first");
  repair_orientation(mesh);
  if (const auto defects = validate(mesh); !defects.empty())
    throw std::runtime_error(defects.front().text);
  return result;
}

}  // namespace tensortopo::filters
