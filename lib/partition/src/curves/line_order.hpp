// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The order of lines by the cells that hold them.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <span>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// The vertices of a simplex by their ranks, ascending; -1 fills up.
inline std::array<TetMesh::Index, 4> ranks_of(std::array<TetMesh::Index, 4> simplex,
                                              std::span<const TetMesh::Index> rank) {
  const auto end = std::find(simplex.begin(), simplex.end(), -1);
  for (auto v = simplex.begin(); v != end; ++v) *v = rank[as_size(*v)];
  std::sort(simplex.begin(), end);
  return simplex;
}

/// Cells in the order in which an extraction lists their lines: tetrahedra, faces, edges.
struct CellOrder {
  std::ptrdiff_t missing = 0;             ///< vertices to a tetrahedron
  std::array<TetMesh::Index, 4> ranks{};  ///< ascending
  /// In the order of the members.
  auto operator<=>(const CellOrder&) const = default;
};

/// @param rank  of each vertex in the canonical order
inline CellOrder order_of_cell(const std::array<TetMesh::Index, 4>& cell,
                               std::span<const TetMesh::Index> rank) {
  return {std::count(cell.begin(), cell.end(), -1), ranks_of(cell, rank)};
}

}  // namespace tensortopo
