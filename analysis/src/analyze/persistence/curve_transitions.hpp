// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "tensortopo/extract/curve_arcs.hpp"

namespace tensortopo {

/// What is proved of the arcs of a degenerate curve, its parts in one tetrahedron each.
struct CurveArcCounts {
  // Along all of an arc.
  std::size_t wedges = 0, trisectors = 0;
  std::size_t mixed = 0;       ///< with transitions inside, all of them known
  std::size_t not_proved = 0;  ///< none of these is proved
  std::size_t zeros = 0;       ///< transitions inside arcs: simple zeros of the separation
  std::size_t jumps = 0;       ///< transitions between two arcs, at a face

  CurveArcCounts& operator+=(const CurveArcCounts& other);
};

/// A point of a degenerate curve at which wedges turn into trisectors.
struct CurveTransition {
  std::size_t curve = 0;             ///< as an index into the report's curves
  bool is_jump = false;              ///< at a face, where the derivative of the field jumps
  std::vector<TetMesh::Index> tets;  ///< one, or the two at the face
  PlaceBox place;                    ///< encloses the point

  /// The largest distance of the point from the middle of the box.
  double radius() const;
};

/// Counts the arcs of each component, and adds the transitions of components in their order, along
/// each.
/// @param components  how many there are
/// @param first       number of the first one in the report
std::vector<CurveArcCounts> count_arcs(const CurveArcs& arcs, std::size_t components,
                                       std::size_t first,
                                       std::vector<CurveTransition>& transitions);

}  // namespace tensortopo
