// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/extract/curve_keys.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// A tetrahedron of the whole mesh, and what is special about its degenerate points.
struct OwnedCurveCell {
  std::int64_t cell_id = -1;  ///< of the whole mesh
  CurveObstacle obstacle{};   ///< as in `UnresolvedCurve`
};

/// The part of the degenerate curves that lies in the tetrahedra that a piece owns, in terms that
/// other pieces understand.
///
/// A line in a face or an edge of the mesh belongs to one of the tetrahedra around, the one that
/// `CurveMesh::tet` names: the piece that owns this tetrahedron has the line.
struct PieceCurves {
  Degeneracy kind = Degeneracy::linear;  ///< of the curves
  /// Lines with their vertices. `tet` and `carrier_vertices` count within `cells`. `component`
  /// counts within the piece, in the order of the keys of first lines.
  CurveMesh curves;
  /// Names of vertices and lines; those of lines count within `cells`. `messages` is empty.
  CurveKeys keys;
  /// Of each vertex: a sum of hashes of the tetrahedra of all lines that end there, those of ghosts
  /// too; 0 inside of a line.
  std::vector<std::uint64_t> around;
  std::vector<char> is_shared;           ///< of each vertex: whether it lies in a ghost, too
  /// The owned tetrahedra that have lines, are unresolved or special, with `cell_ids`.
  TetMesh cells;
  std::vector<std::int64_t> vertex_ids;  ///< of the points of `cells`
  std::vector<OwnedCurveCell> unresolved;              ///< as in `CurveExtraction`, by id
  std::vector<OwnedCurveCell> special;                 ///< as in `CurveExtraction`, by id
  std::vector<std::array<std::int64_t, 2>> owned_ids;  ///< as in `PieceSurface`
  std::int64_t whole_tets = 0;                         ///< tetrahedra of the whole mesh
  /// What owned tetrahedra tell ghosts (`CurveKeys::messages`); ascending.
  std::vector<PieceMessage> told;
  /// What ghosts tell owned tetrahedra, as this piece sees it; ascending.
  std::vector<PieceMessage> heard;
};

/// Extracts the degenerate curves in the tetrahedra that a piece owns.
///
/// What an owned tetrahedron holds, and the points on its faces, edges and vertices, depend on the
/// tetrahedra that share a vertex with it: all are in the piece. What becomes of a line in a face
/// or edge depends on what is around it, ghosts too, and these may lack neighbours: `told` and
/// `heard` say what was found there, and `merge_curve_pieces` compares.
///
/// @pre the contract of `MeshPiece`
/// @throws std::invalid_argument as `require_sound`
PieceCurves extract_curve_piece(const MeshPiece& piece, Degeneracy kind,
                                const ExtractOptions& options = {});

/// What lies in the tetrahedra that a piece owns of curves that were extracted from its mesh.
///
/// @pre the contract of `MeshPiece`
/// @param made  in numbers of the piece's mesh
/// @throws std::invalid_argument as `require_sound`, or if the vertices of the piece are not in the
///         order of their ids, in which those at one place have to be extracted
PieceCurves owned_curves(const MeshPiece& piece, Degeneracy kind, KeyedCurves made);

/// The degenerate curves of a whole mesh.
struct MergedCurves {
  Degeneracy kind = Degeneracy::linear;  ///< of the curves
  /// As `extract_degenerate_curves` gives them, in the same order. `tet` and `carrier_vertices` are
  /// ids in the whole mesh where all of these are below 2^31, else -1.
  CurveMesh curves;
  std::vector<std::int64_t> cell_ids;                    ///< of each line
  std::vector<std::array<std::int64_t, 4>> carrier_ids;  ///< of each vertex; ascending, -1 fills up
  std::vector<OwnedCurveCell> unresolved;                ///< by id
  std::vector<OwnedCurveCell> special;                   ///< by id
  /// Those with lines, unresolved or special, ascending by id, with `cell_ids`.
  TetMesh cells;
  std::vector<std::int64_t> vertex_ids;  ///< of the points of `cells`, ascending
  std::int64_t whole_tets = 0;           ///< tetrahedra of the whole mesh
};

/// Merged curves in numbers of the mesh `merged.cells`, as `CurveArcs` takes them.
CurveMesh curves_in_cells(const MergedCurves& merged);

/// Puts the pieces of curves together. The order of the pieces does not matter.
///
/// Law       The result is what the whole mesh gives, bit for bit and in the same order.
/// Proved    Every tetrahedron of the whole mesh is owned by exactly one of the pieces. Around each
///           edge and face with lines, ghosts hold what they hold in the pieces of their owners, so
///           each such line is in one piece. Each piece saw the lines at the vertices that it
///           shares in the tetrahedra in which the pieces of their owners have them.
/// @throws std::invalid_argument if a piece is missing, if one has curves of another kind; with the
///         place, if the pieces are not those of one mesh
/// @throws PiecesDiffer with the place, if a ghost holds other than in its owner's piece, or if
///         vertices with one key differ
MergedCurves merge_curve_pieces(std::span<const PieceCurves> pieces);

}  // namespace tensortopo
