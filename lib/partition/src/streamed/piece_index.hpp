// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tensortopo/mesh/torn_faces.hpp"
#include "tensortopo/partition/extract_streamed.hpp"

namespace tensortopo {

/// Of each vertex whether it lies on a face of one tetrahedron, or in none: only these may be
/// vertices of other pieces.
std::vector<char> outer_vertices(const TetMesh& mesh);

/// What one of several pieces has in the whole mesh.
struct IndexedPiece {
  std::int64_t first_point = 0;  ///< the id of the first point that no piece before has
  std::int64_t first_tet = 0;    ///< the id of its first tetrahedron
  std::size_t points = 0, tets = 0;
  /// Its points that a piece before has: number and id, ascending.
  std::vector<std::pair<TetMesh::Index, std::int64_t>> known;
  std::vector<std::int32_t> neighbours;  ///< pieces that share points with it, ascending

  /// The ids of its points.
  std::vector<std::int64_t> point_ids() const;
  /// Calls f for the numbers of the points that no piece before has.
  template <class F>
  void for_each_new_point(const F& f) const {
    auto next = known.begin();
    for (std::size_t v = 0; v < points; ++v) {
      if (next != known.end() && as_size(next->first) == v)
        ++next;
      else
        f(v);
    }
  }
};

namespace detail {

/// Numbers points and tetrahedra of all pieces, in the order in which they come first. Only points
/// on faces of one tetrahedron, or in none, are looked for in other pieces.
struct PieceIndex {
  std::vector<IndexedPiece> pieces;
  std::int64_t points = 0, tets = 0;
  TornFaces torn_faces;  ///< of the whole mesh

  /// Reads each piece twice. Throws as `StreamedMesh`.
  explicit PieceIndex(const PieceSource& source);
};

}  // namespace detail

}  // namespace tensortopo
