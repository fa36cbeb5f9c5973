// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "extract/topology/boundary/cell_boundary.hpp"

namespace tensortopo::detail {

/// Where paths between loops are looked for: between their places on the degenerate curve, halving
/// what is between; or else also along whole arcs of that curve, which are such paths themselves if
/// they are proved, and along walks on it, up to where two of them come closest.
enum class Search { chords, everything };

/// Which boundary loops of a near-degenerate level border one and the same part of the tetrahedron
/// beyond the level, as far as paths between them show it: arcs of the degenerate curve, or chains
/// of straight segments along it, each of them proved not to meet the level.
///
/// @param parts  no more paths are looked for when loops are joined to so many parts
/// @return for each loop a number; two loops with the same number certainly border the same part
template <class Scalar>
std::vector<int> loops_joined_in_superlevel_set(const TetWithCurves<Scalar>& tet,
                                                const Level<Scalar>& level,
                                                const BoundaryLoops& loops, int parts,
                                                Search search);

}  // namespace tensortopo::detail
