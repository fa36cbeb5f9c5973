// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// What others must know of a piece's surface to number its components in the whole: its components
/// and their counts, and its vertices and sides of triangles where it may meet other pieces.
///
/// Size      In proportion to the seam and to the number of components, not to the surface.
struct SurfaceSeam {
  using Index = TetMesh::Index;  ///< of a component, a vertex of the seam, or a tetrahedron

  /// A connected component of the triangles in the tetrahedra that the piece owns.
  struct Component {
    std::int64_t vertices = 0;              ///< that its triangles have
    std::int64_t triangles = 0;             ///< how many it has
    std::int64_t euler_characteristic = 0;  ///< vertices - edges + triangles
    std::int64_t closed_borders = 0;        ///< of its borders (see `Vertex`) those off the seam
    Index first_tet = -1;                   ///< in `cells`: the tetrahedron of its first triangle
  };
  /// A vertex that other pieces may have.
  ///
  /// The triangles around a vertex of the whole surface are one fan. If several pieces have some of
  /// them, consecutive ones of different pieces meet in sides on the seam: so a vertex that several
  /// pieces have is an end of such a side in each of them, whether or not these pieces have
  /// tetrahedra with a common face.
  struct Vertex {
    /// Ids of the vertices of the simplex that holds it, ascending; -1 fills up.
    std::array<std::int64_t, 4> carrier_ids{-1, -1, -1, -1};
    std::int32_t ordinal = 0;  ///< as `PieceSurface::ordinals`
    Index component = -1;      ///< that it belongs to
    /// The border through it, or -1: a connected set of sides with one triangle in the whole
    /// surface, numbered within the piece.
    Index border = -1;
    std::uint64_t digest = 0;  ///< of all numbers that pieces which have the vertex agree on
  };
  /// A side of an owned triangle on a face to a ghost, or on an edge of the mesh.
  struct Side {
    Index from = -1;             ///< in `vertices`, the first in the triangle's direction
    Index to = -1;               ///< in `vertices`, the second
    std::int64_t cell_id = -1;   ///< the tetrahedron of the triangle
    std::int64_t ghost_id = -1;  ///< the tetrahedron across the face; -1 on an edge of the mesh
  };

  /// As `surface_components(piece.surface)` numbers them.
  std::vector<Component> components;
  std::vector<Vertex> vertices;          ///< each once
  std::vector<Side> sides;               ///< of different triangles there may be two alike
  TetMesh cells;                         ///< those with first triangles, with `cell_ids`
  std::vector<std::int64_t> vertex_ids;  ///< of the points of `cells`
  std::vector<std::int64_t> unresolved;  ///< ids of owned tetrahedra without a proof
  std::vector<std::array<std::int64_t, 2>> owned_ids;  ///< as in `PieceSurface`
  std::int64_t whole_tets = 0;                         ///< tetrahedra of the whole mesh
  std::vector<PieceMessage> told;                      ///< as in `PieceSurface`
  std::vector<PieceMessage> heard;                     ///< as in `PieceSurface`
};

/// The seam of a piece.
SurfaceSeam seam_of(const PieceSurface& piece);

/// The components of a whole surface, and what they are called in its pieces.
struct JoinedSeams {
  using Index = SurfaceMesh::Index;  ///< of a component

  /// A connected component of the whole surface.
  struct Component {
    std::int64_t vertices = 0;              ///< that its triangles have
    std::int64_t triangles = 0;             ///< how many it has
    std::int64_t euler_characteristic = 0;  ///< vertices - edges + triangles
    std::int64_t boundary_loops = 0;        ///< closed curves of edges with one triangle
  };

  std::vector<Component> components;  ///< in the order of their first triangles in the whole
  /// Of each seam given, of each of its components: which one of `components` it belongs to.
  std::vector<std::vector<Index>> numbers;

  Component total() const;  ///< the sums
};

/// What the seams of all pieces say of the whole surface. The order of the seams does not matter.
///
/// Law       Components, their order and their numbers are those of `merge_pieces` and of the
///           extraction from the whole mesh.
/// Proved    As by `merge_pieces`: every tetrahedron of the whole mesh is owned by one piece, in
///           each piece ghosts told what they told in the pieces of their owners, vertices with one
///           key agree, by a hash of their numbers, and each side on a face to a ghost has a
///           partner, unless the ghost has no proof in its owner's piece.
/// @throws std::invalid_argument as `merge_pieces`: if a piece is missing, or a tetrahedron has two
///         owners
/// @throws PiecesDiffer with the place, if a ghost tells otherwise than in its owner's piece, if
///         vertices with one key differ, or if a side has no partner
JoinedSeams join_seams(std::span<const SurfaceSeam> seams);

}  // namespace tensortopo
