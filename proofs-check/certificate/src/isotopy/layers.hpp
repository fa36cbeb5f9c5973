// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Triangles that move across the level as the layers of a product.
#pragma once

#include "distances/moved_vertices.hpp"
#include "isotopy/apart.hpp"

namespace certificate {

/// The triangles of a tetrahedron, with corners anywhere between the places behind the level and
/// those ahead of it: an embedding of the triangles times an interval.
class Layers {
 public:
  /// @param places  all places between each vertex and the point that it stands for
  Layers(const LevelCase& c, const PlacedSurface& placed, const MovedVertices& moved,
         std::span<const BallPoint> places)
      : c_(c), placed_(placed), moved_(moved), places_(places) {}

  /// Does each triangle have an area, do any two meet only in the vertices and the edge that they
  /// share, and do the corners of each move to its side of larger values, wherever each corner is
  /// in the box around its vertex, the point that this stands for, and both moved ones? True only
  /// if proved, in doubles.
  /// @param triangles  of the level, all of one tetrahedron
  /// @pre all their vertices stay in their carriers
  bool are_embedded(std::span<const std::size_t> triangles) const;

 private:
  struct Span {
    BallPoint box, step;  ///< all places; from behind to ahead
  };
  Span span_of(std::size_t vertex) const;

  const LevelCase& c_;
  const PlacedSurface& placed_;
  const MovedVertices& moved_;
  std::span<const BallPoint> places_;
};

}  // namespace certificate
