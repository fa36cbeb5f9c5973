// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What of a surface lies in owned tetrahedra.
#pragma once

#include <array>
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

/// Takes out triangles in ghosts, and vertices that no other triangle has and no proof names.
/// @param result  whose triangles' `tet` count in the piece's mesh
void keep_owned(const MeshPiece& piece, PieceSurface& result);

/// Gathers the tetrahedra with triangles, without a proof or with two isotropic vertices, and counts in
/// terms of these.
/// @param result  in numbers of the piece's mesh; its `unresolved` are those of owned tetrahedra
void gather_cells(const MeshPiece& piece, PieceSurface& result);

}  // namespace tensortopo
