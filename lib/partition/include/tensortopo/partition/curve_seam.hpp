// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/partition/piece_curves.hpp"

namespace tensortopo {

/// What others must know of a piece's curves to number their components in the whole: these with
/// their counts, and the vertices where lines of other pieces may end.
///
/// Size      In proportion to the number of such vertices and of components, not to the curves.
struct CurveSeam {
  using Index = TetMesh::Index;  ///< of a component, or a point

  /// A connected component of the lines in the tetrahedra that the piece owns.
  struct Component {
    std::int64_t vertices = 0;   ///< that its lines have
    std::int64_t lines = 0;      ///< how many it has
    std::int64_t ends = 0;       ///< vertices off the seam at which one line ends
    std::int64_t junctions = 0;  ///< vertices off the seam at which more than two lines end
    /// The vertices of the cell that holds its first line, in `cells`; -1 fills up.
    std::array<Index, 4> first_cell{-1, -1, -1, -1};
  };
  /// A vertex that lies in a ghost, too.
  struct Vertex {
    /// Ids of the vertices of the simplex that holds it, ascending; -1 fills up.
    std::array<std::int64_t, 4> carrier_ids{-1, -1, -1, -1};
    std::int32_t ordinal = 0;    ///< as `CurveKeys::Vertex`
    Index component = -1;        ///< that it belongs to
    std::int32_t line_ends = 0;  ///< lines of the piece that end there
    std::uint64_t owned = 0;     ///< as `around`, of these lines
    std::uint64_t around = 0;    ///< as `PieceCurves::around`
    std::uint64_t digest = 0;    ///< of all numbers that pieces which have the vertex agree on
  };

  Degeneracy kind = Degeneracy::linear;  ///< of the curves
  std::vector<Component> components;     ///< as `piece.curves.component` numbers them
  std::vector<Vertex> vertices;          ///< each once
  TetMesh cells;                         ///< points of first cells, without tetrahedra
  std::vector<std::int64_t> vertex_ids;  ///< of the points of `cells`
  std::vector<std::array<std::int64_t, 2>> owned_ids;  ///< as in `PieceSurface`
  std::int64_t whole_tets = 0;                         ///< tetrahedra of the whole mesh
  std::vector<PieceMessage> told;                      ///< as in `PieceCurves`
  std::vector<PieceMessage> heard;                     ///< as in `PieceCurves`
};

/// The seam of a piece.
CurveSeam curve_seam_of(const PieceCurves& piece);

/// The components of whole curves, and what they are called in their pieces.
struct JoinedCurveSeams {
  using Index = CurveMesh::Index;  ///< of a component

  /// A connected component of the whole curves. Lengths are not counted: their sums depend on the
  /// order.
  struct Component {
    std::int64_t vertices = 0;   ///< that its lines have
    std::int64_t lines = 0;      ///< how many it has
    std::int64_t ends = 0;       ///< vertices at which one line ends; none if it is closed
    std::int64_t junctions = 0;  ///< vertices at which more than two lines end
  };

  std::vector<Component> components;  ///< in the order of their first lines in the whole
  /// Of each seam given, of each of its components: which one of `components` it belongs to.
  std::vector<std::vector<Index>> numbers;

  Component total() const;                 ///< the sums
  std::int64_t closed_components() const;  ///< those without ends
};

/// What the seams of all pieces say of the whole curves. The order of the seams does not matter.
///
/// Law       Components, their order and their numbers are those of `merge_curve_pieces` and of the
///           extraction from the whole mesh.
/// Proved    As by `merge_curve_pieces`; vertices with one key are compared by a hash of their
///           numbers.
/// @throws std::invalid_argument as `merge_curve_pieces`
/// @throws PiecesDiffer as `merge_curve_pieces`
JoinedCurveSeams join_curve_seams(std::span<const CurveSeam> seams);

}  // namespace tensortopo
