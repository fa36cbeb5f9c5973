// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What of a surface lies in owned tetrahedra.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// Ids as `PieceSurface::owned_ids` has them.
std::vector<std::array<std::int64_t, 2>> runs_of(std::vector<std::int64_t> ids);

/// Whether an id is in runs as `PieceSurface::owned_ids`.
/// @pre the runs are ascending
bool owns(std::span<const std::array<std::int64_t, 2>> owned_ids, std::int64_t id);

/// With vertices in the order of their ids, which is the order of vertices at one place.
MeshPiece in_order_of_ids(const MeshPiece& piece);

/// Leaves the values whose number is marked.
template <class T>
void keep(std::vector<T>& values, const std::vector<char>& is_kept) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (is_kept[i]) values[kept++] = values[i];
  values.resize(kept);
}

/// Numbers from 0 for those that are marked, in their order; -1 for the others.
std::vector<TetMesh::Index> numbers_of_kept(const std::vector<char>& is_kept);

/// New numbers of what was kept; -1 for what was not.
struct KeptCells {
  std::vector<TetMesh::Index> tet, vertex;
};

/// Makes a mesh of some of the tetrahedra of a piece, with their points.
/// @param is_kept  of each tetrahedron
KeptCells keep_cells(const MeshPiece& piece, const std::vector<char>& is_kept, TetMesh& cells,
                     std::vector<std::int64_t>& vertex_ids);

/// Takes out triangles in ghosts, and vertices that no other triangle has and no proof names.
/// @param result  whose triangles' `tet` count in the piece's mesh
void keep_owned(const MeshPiece& piece, PieceSurface& result);

/// Gathers the tetrahedra with triangles, without a proof or with two isotropic vertices, and
/// counts in terms of these.
/// @param result  in numbers of the piece's mesh; its `unresolved` are those of owned tetrahedra
void gather_cells(const MeshPiece& piece, PieceSurface& result);

}  // namespace tensortopo
