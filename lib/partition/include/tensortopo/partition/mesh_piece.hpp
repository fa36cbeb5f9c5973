// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// One of the pieces that a mesh was cut into, as one process holds it: the tetrahedra that it
/// owns, and around them others, its ghosts.
///
/// Contract  (1) Each tetrahedron of the whole mesh is owned by one piece. (2) A piece has every
///           tetrahedron of the whole mesh that shares a vertex with one that it owns. (3) Points,
///           tensors and ids are the same, bit for bit, wherever a vertex or tetrahedron is
///           repeated. (4) Each piece knows how many tetrahedra the whole mesh has. Numbers
///           within the piece, the order of its tetrahedra and of their corners do not matter.
struct MeshPiece {
  TetMesh mesh;                          ///< valid; `cell_ids` are those of the whole mesh
  std::vector<std::int64_t> vertex_ids;  ///< of each point, in the whole mesh; at least 0
  std::vector<char> is_owned;            ///< of each tetrahedron
  std::int64_t whole_tets = 0;           ///< tetrahedra of the whole mesh
};

/// @throws std::invalid_argument if lists differ in length, if ids are negative or repeat within
///         the piece, or if the whole mesh has fewer tetrahedra than the piece; the message names
///         the id or the numbers
void require_sound(const MeshPiece& piece);

/// The ids of all tetrahedra that a piece owns, as runs from a first to a last id: ascending, and
/// apart from each other.
std::vector<std::array<std::int64_t, 2>> owned_ids_of(const MeshPiece& piece);

/// A piece of a mesh, with ids that are the mesh's own numbers (not its `cell_ids`).
/// @param owner  of each tetrahedron the piece that owns it
/// @param layers  how many layers of ghosts, each of the tetrahedra that share a vertex with those
///                before
MeshPiece cut_piece(const TetMesh& mesh, std::span<const std::int32_t> owner, std::int32_t piece,
                    int layers = 1);

/// Owners of a mesh's tetrahedra for so many pieces of nearly equal size: slabs across the x axis,
/// by the canonical order of the tetrahedra (`CanonicalMesh`).
/// @param pieces  at least 1
std::vector<std::int32_t> slabs(const TetMesh& mesh, std::int32_t pieces);

}  // namespace tensortopo
