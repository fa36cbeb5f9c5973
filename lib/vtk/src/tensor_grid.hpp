// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkSmartPointer.h>
#include <vtkType.h>
#include <vtkUnstructuredGrid.h>

#include <cstddef>
#include <string>
#include <vector>

#include "tensortopo/partition/mesh_piece.hpp"

class vtkDataArray;

namespace tensortopo::filters {

/// A grid's field, as the library takes it.
struct TensorGrid {
  vtkUnstructuredGrid* grid = nullptr;
  /// Its mesh is valid. Ids are global ones, or positions in the grid; vertices are in their order.
  MeshPiece piece;
  bool has_ids = false;          ///< both ids are global ones
  std::vector<vtkIdType> cells;  ///< of each tetrahedron, in the grid
  std::string tensor;            ///< the array's name
  std::string components;        ///< the order of its six components, or "full"
};

/// The field of the point tensors `tensors`.
///
/// Points and cells are in the order of their global ids, if they have these; points of one id,
/// place and tensor are one. Cells of lower
/// dimension are passed over.
/// @param order  as vtkTensorTopology::ComponentOrder
/// Throws std::runtime_error for other cells, for tensors that are none, and for meshes that are no
/// domain of a field, with the reason.
TensorGrid tensor_grid(vtkUnstructuredGrid* grid, vtkDataArray* tensors, int order);

/// The only point array of six or nine components; throws std::runtime_error if there is none, or
/// several.
vtkDataArray* only_tensors(vtkUnstructuredGrid* grid);

/// Those of some triangles or lines that lie in tetrahedra which a piece owns.
/// @param tets   of each triangle or line
/// @param first  of those that are looked at
std::vector<std::size_t> own_cells(const MeshPiece& piece, const std::vector<TetMesh::Index>& tets,
                                   std::size_t first, std::size_t count);

}  // namespace tensortopo::filters
