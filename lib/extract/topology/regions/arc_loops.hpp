// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "extract/topology/boundary/cell_boundary.hpp"
#include "tensortopo/field/degenerate_arcs.hpp"

namespace tensortopo::detail {

/// An arc of the degenerate curve and the boundary loops next to its ends, its own first.
struct ArcBetweenLoops {
  DegenerateArc arc;
  std::array<int, 2> loops;
};

/// The arcs of the degenerate curve next to the level and the loops that they join.
///
/// On a face the part in the superlevel set in which an arc ends is bounded by arcs of the level:
/// if these are of one loop, it is that. An arc is itself a path in the superlevel set, so what is
/// beyond the level on the boundary next to its two loops is joined.
///
/// @return only those arcs for which this is proved
template <class Scalar>
std::vector<ArcBetweenLoops> arcs_between_loops(const TetWithCurves<Scalar>& tet,
                                                const Level<Scalar>& level,
                                                const BoundaryLoops& loops);

}  // namespace tensortopo::detail
