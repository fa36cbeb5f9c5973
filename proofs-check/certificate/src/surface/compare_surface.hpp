// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "claims/compare_level.hpp"

namespace certificate {

/// The edge, face or tetrahedron that holds a vertex of the surface; the vertex that a tip is at.
struct Carrier {
  std::array<Vertex, 4> corners{};
  std::size_t count = 0;
};
/// A closed curve of triangles on a face, named by its smallest vertex.
struct ClosedLoop {
  Vertex opposite;
  std::vector<Number> vertices;
};
/// A piece of triangles without boundary.
struct ClosedPiece {
  long euler_characteristic = 0;
  std::vector<std::size_t> triangles;  ///< of the level
};
/// The triangles of a level, found to be as claimed.
struct PlacedSurface {
  std::vector<Carrier> carriers;   ///< of each vertex of the level
  std::vector<std::size_t> tets;   ///< of each triangle, among the tetrahedra of the input
  /// The sheets that meet no edge: their tetrahedra, and their loops.
  std::vector<std::pair<std::size_t, std::vector<ClosedLoop>>> closed_sheets;
  std::vector<std::pair<std::size_t, ClosedLoop>> closed_curves;   ///< all, by tetrahedra
  std::map<std::size_t, std::vector<ClosedPiece>> closed_pieces;   ///< by tetrahedra
  /// All simplices in which vertices must lie, but crossings' edges.
  std::vector<std::pair<Number, Carrier>> places;
  /// Where triangles end at a face of one tetrahedron: vertices along an arc or closed curve, in the
  /// direction of the triangles.
  struct BorderChain {
    std::array<Vertex, 3> face{};
    std::vector<Number> vertices;  ///< of a closed curve each once
    bool closed = false;
  };
  std::vector<BorderChain> border;
};

/// Is there no mode, or other invariant: at a tip, or between two?
inline bool is_apex(const LevelCase& c, const Carrier& carrier) {
  return std::all_of(carrier.corners.begin(),
                     carrier.corners.begin() + static_cast<std::ptrdiff_t>(carrier.count),
                     [&](Vertex v) { return c.field.is_zero(v); });
}

/// The triangles of a level: are they a surface, oriented, whose part in each tetrahedron has the
/// claimed sheets with their loops, glued across faces along the same curves, and are its
/// components as claimed? One claim for each component, and one for all of the pieces.
///
/// Nothing if they are not.
std::optional<PlacedSurface> compare_surface(const LevelCase& c,
                                             const CrossingVertices& vertices, Ledger& ledger);

}  // namespace certificate
