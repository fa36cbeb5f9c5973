// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::detail {

/// What a cell type of VTK is to us.
struct CellKind {
  enum class Use {
    skip,         ///< of dimension 0, 1 or 2
    tetrahedron,  ///< taken
    split,        ///< linear and 3D: can be split into tetrahedra
    refuse,       ///< curved, or with faces of its own
    unknown,
  };
  std::string_view name;  ///< in the plural
  Use use;
  std::size_t corners;  ///< of tetrahedra and cells that can be split
};

CellKind cell_kind(std::uint8_t vtk_type);

/// The quadrilaterals of a linear 3D cell that can be split: of each, corners in order around it.
std::vector<std::array<TetMesh::Index, 4>> quadrilaterals(std::uint8_t vtk_type,
                                                          std::span<const TetMesh::Index> corners);

/// Splits a linear 3D cell into tetrahedra that it appends to `tets`.
///
/// The cell's smallest vertex is joined to the triangles of all faces that do not hold it, and each
/// face is a fan from its own smallest vertex. So two cells that share a face split it alike. Parts
/// that repeat a vertex are left out. Orientation is as may be.
void split_cell(std::uint8_t vtk_type, std::span<const TetMesh::Index> corners,
                std::vector<std::array<TetMesh::Index, 4>>& tets);

}  // namespace tensortopo::detail
