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

/// A `MeshingMessage`, in terms that other pieces understand.
struct PieceMessage {
  std::int64_t from_cell = -1;  ///< id in the whole mesh
  std::int64_t to_cell = -1;    ///< as well
  std::int32_t pass = 0;        ///< as in `MeshingMessage`
  std::int32_t round = 0;       ///< as in `MeshingMessage`
  std::uint64_t digest = 0;     ///< as in `MeshingMessage`
  /// In the order of the members.
  auto operator<=>(const PieceMessage&) const = default;
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
  /// The owned tetrahedra that hold triangles, have no proof or have two isotropic vertices, with
  /// `cell_ids` of the whole mesh.
  TetMesh cells;
  std::vector<std::int64_t> vertex_ids;         ///< of the points of `cells`
  std::vector<UnresolvedOwnedCell> unresolved;  ///< those without a proof
  /// Ids of owned tetrahedra as `Extraction::not_embedded` has them, ascending.
  std::vector<std::int64_t> not_embedded;
  /// The ids of all tetrahedra that the piece owns, as runs from a first to a last id: ascending,
  /// and apart from each other.
  std::vector<std::array<std::int64_t, 2>> owned_ids;
  /// Of these, those that are isotropic at all four vertices: no mode there, and no surface.
  std::vector<std::array<std::int64_t, 2>> isotropic_ids;
  std::int64_t whole_tets = 0;  ///< tetrahedra of the whole mesh
  /// With `ExtractOptions::keep_topology`, what was proved of the owned tetrahedra: in numbers of
  /// `cells` and of the vertices of `surface`, which then has all that it names. `copies` is empty.
  std::optional<LevelTopology> topology;
  /// The ids of vertices whose mode is exactly the surface's, ascending: of those of owned
  /// tetrahedra, and of those that no tetrahedron of the piece has.
  std::vector<std::int64_t> on_level;
  /// What owned tetrahedra told ghosts while they were meshed; ascending.
  std::vector<PieceMessage> told;
  /// What ghosts told owned tetrahedra, as this piece saw it; ascending.
  std::vector<PieceMessage> heard;
};

/// Extracts the mode surface in the tetrahedra that a piece owns.
///
/// The triangles are those of the extraction from the whole mesh, bit for bit: what becomes of a
/// tetrahedron depends on its own field and on what its neighbours tell it, step by step. A ghost
/// may tell otherwise than in its owner's piece, as it lacks neighbours: `merge_pieces` compares.
///
/// @pre the contract of `MeshPiece`; the mode is not +-1
/// @param options  `density` counts the tetrahedra of the piece
/// @throws std::invalid_argument as `require_sound`
PieceSurface extract_piece(const MeshPiece& piece, const ModeValue& mode,
                           const ExtractOptions& options = {});

/// What lies in the tetrahedra that a piece owns of a surface that was extracted from its mesh by
/// other means than `extract_piece`.
///
/// @pre the contract of `MeshPiece`
/// @param surface  in numbers of the piece's mesh
/// @return `unresolved`, `not_embedded`, `topology`, `on_level`, `told` and `heard` are empty
/// @throws std::invalid_argument as `require_sound`, or if the vertices of the piece are not in the
///         order of their ids, in which those at one place have to be extracted
PieceSurface owned_surface(const MeshPiece& piece, SurfaceMesh surface);

/// The same of all that an extraction from the piece's mesh found.
///
/// @pre the contract of `MeshPiece`
/// @param made      in numbers of the piece's mesh
/// @param is_proof  it was extracted with `ExtractOptions::keep_topology`: so is the result
/// @return `told` and `heard` are of `made.messages`
/// @throws std::invalid_argument as above
PieceSurface owned_surface(const MeshPiece& piece, const ModeValue& mode, Extraction made,
                           bool is_proof);

/// The surface of a whole mesh.
struct MergedSurface {
  /// As `extract_mode_surface` gives it, in the same order; `carrier_id` is empty. `tet` and
  /// `carrier_vertices` are ids in the whole mesh where all of these are below 2^31, else -1.
  SurfaceMesh surface;
  std::vector<std::int64_t> cell_ids;                    ///< of each triangle
  std::vector<std::array<std::int64_t, 4>> carrier_ids;  ///< of each vertex; ascending, -1 fills up
  std::vector<UnresolvedOwnedCell> unresolved;           ///< by id
  std::vector<std::int64_t> not_embedded;                ///< as those of the pieces, ascending
  /// The tetrahedra that the pieces have, ascending by id, with `cell_ids`.
  TetMesh cells;
  std::vector<std::int64_t> vertex_ids;  ///< of the points of `cells`, ascending
  std::int64_t whole_tets = 0;           ///< tetrahedra of the whole mesh
  /// Of pieces that all have one: in numbers of `cells` and `surface`.
  std::optional<LevelTopology> topology;
  std::size_t vertices_on_level = 0;  ///< as in `ExtractStatistics`
  std::size_t tets_undefined = 0;     ///< as in `ExtractStatistics`
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
///           that they own are distinct, and as many as the whole mesh has tetrahedra. In each
///           piece ghosts told owned tetrahedra what they told them in the pieces of their owners:
///           so, step by step, all were meshed as in the whole mesh.
/// @throws std::invalid_argument if a piece is missing; with the place, if the pieces are not those
///         of one mesh: if a vertex has two places or tensors, or a tetrahedron two owners
/// @throws PiecesDiffer with the place, if a ghost tells otherwise than in its owner's piece, if
/// vertices
///         with one key differ, if what was proved of an
///         edge or face differs, or if a triangle's side on the seam of a piece has no partner in
///         another piece
MergedSurface merge_pieces(std::span<const PieceSurface> pieces);

}  // namespace tensortopo
