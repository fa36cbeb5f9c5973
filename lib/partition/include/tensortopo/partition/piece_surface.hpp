// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/partition/mesh_piece.hpp"

namespace tensortopo {

/// A tetrahedron of the whole mesh that was not extracted.
struct UnresolvedOwnedCell {
  std::int64_t cell_id = -1;  ///< of the whole mesh
  UnresolvedReason reason;    ///< why
};

/// The part of a mode surface that lies in the tetrahedra that a piece owns, in terms that other
/// pieces understand.
struct PieceSurface {
  /// Vertices and triangles. `tet` counts within `cells`; `carrier_id` and `component` are empty,
  /// and `carrier_vertices` count within `cells` too.
  SurfaceMesh surface;
  /// Of each vertex which one it is of those that its carrier has, in an order that all pieces
  /// agree on. With the ids of the carrier's vertices it is the key of the vertex.
  std::vector<std::int32_t> ordinals;
  /// Of each side of each triangle (from a corner to the next one), if it lies on a face between a
  /// tetrahedron that the piece owns and a ghost, the ghost's id; else -1.
  std::vector<std::array<std::int64_t, 3>> ghost_across;
  /// The owned tetrahedra that hold triangles or have no proof, with `cell_ids` of the whole mesh.
  TetMesh cells;
  std::vector<std::int64_t> vertex_ids;         ///< of the points of `cells`
  std::vector<UnresolvedOwnedCell> unresolved;  ///< those without a proof
  /// Ids of owned tetrahedra as `Extraction::not_embedded` has them, ascending.
  std::vector<std::int64_t> not_embedded;
  /// The ids of all tetrahedra that the piece owns, as runs from a first to a last id: ascending,
  /// and apart from each other.
  std::vector<std::array<std::int64_t, 2>> owned_ids;
  std::int64_t whole_tets = 0;  ///< tetrahedra of the whole mesh
  /// With `ExtractOptions::keep_topology`, what was proved of the owned tetrahedra: in numbers of
  /// `cells` and of the vertices of `surface`, which then has all that it names. `copies` is empty.
  std::optional<LevelTopology> topology;
  /// The ids of vertices whose mode is exactly the surface's, ascending: of those of owned
  /// tetrahedra, and of those that no tetrahedron of the piece has.
  std::vector<std::int64_t> on_level;
};

/// Extracts the mode surface in the tetrahedra that a piece owns.
///
/// The triangles are those of the extraction from the whole mesh, bit for bit: what becomes of a
/// tetrahedron depends on tetrahedra that are at most three faces away, and these share a vertex
/// with it. Where it depends on more (a ghost on the outside asks for samples that a tetrahedron
/// beyond it would have asked for as well), pieces may differ where they meet, and `merge_pieces`
/// says so.
///
/// @pre the contract of `MeshPiece`; the mode is not +-1
/// @param options  `density` counts the tetrahedra of the piece
/// @throws std::invalid_argument as `require_sound`
PieceSurface extract_piece(const MeshPiece& piece, const ModeValue& mode,
                           const ExtractOptions& options = {});

/// The surface of a whole mesh.
struct MergedSurface {
  /// As `extract_mode_surface` gives it, in the same order; `carrier_id` is empty. `tet` and
  /// `carrier_vertices` are ids in the whole mesh where all of these are below 2^31, else -1.
  SurfaceMesh surface;
  std::vector<std::int64_t> cell_ids;                    ///< of each triangle
  std::vector<std::array<std::int64_t, 4>> carrier_ids;  ///< of each vertex; ascending, -1 fills up
  std::vector<UnresolvedOwnedCell> unresolved;           ///< by id
  std::vector<std::int64_t> not_embedded;                ///< as those of the pieces, ascending
  /// The tetrahedra that hold triangles or have no proof, ascending by id, with `cell_ids`.
  TetMesh cells;
  std::vector<std::int64_t> vertex_ids;  ///< of the points of `cells`, ascending
  std::int64_t whole_tets = 0;           ///< tetrahedra of the whole mesh
  /// Of pieces that all have one: in numbers of `cells` and `surface`.
  std::optional<LevelTopology> topology;
  std::size_t vertices_on_level = 0;  ///< as in `ExtractStatistics`
};

/// Pieces that do not agree where they meet: they need more layers of ghosts, or were extracted
/// with different options.
class PiecesDiffer : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Puts the pieces of a surface together. The order of the pieces does not matter.
///
/// Law       The result is the surface that the whole mesh gives, bit for bit and in the same
///           order.
/// Proved    Every tetrahedron of the whole mesh is owned by exactly one of the pieces: the ids
///           that they own are distinct, and as many as the whole mesh has tetrahedra.
/// @throws std::invalid_argument if a piece is missing; with the place, if the pieces are not those
///         of one mesh: if a vertex has two places or tensors, or a tetrahedron two owners
/// @throws PiecesDiffer with the place, if vertices with one key differ, if what was proved of an
///         edge or face differs, or if a triangle's side on the seam of a piece has no partner in
///         another piece
MergedSurface merge_pieces(std::span<const PieceSurface> pieces);

}  // namespace tensortopo
