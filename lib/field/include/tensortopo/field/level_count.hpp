// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tensortopo/field/cell_critical_points.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// What the critical points of the mode on one side of a level prove of that level.
struct LevelCount {
  /// Euler characteristics of what is on that side of the level: in the tetrahedron, and on its
  /// boundary. Tubes around degenerate curves are not counted.
  int inside = 0, boundary = 0;
  /// How often levels that come from that side's end are joined to themselves or to others, by a
  /// bridge: no sheet has more handles, nor have all together.
  int bridges = 0;

  /// The Euler characteristic of the level in the tetrahedron, all of its sheets together.
  int level() const { return 2 * inside - boundary; }
};

/// Counts the critical points of the mode in a tetrahedron, its faces, edges and vertices, on one
/// side of a level.
///
/// By stratified Morse theory the part M of a tetrahedron where the mode is larger changes as the
/// level falls past a critical point only if the mode falls from there into all cells around: by a
/// cell of as many dimensions as there are directions along the stratum in which the mode grows.
/// The same holds for F, the part of M on the boundary, where at a vertex or an edge from which the
/// mode grows in all directions a cell of one dimension more closes a hole. M is bounded by F and
/// the level, glued along closed curves, so the level has the Euler characteristic 2 chi(M) -
/// chi(F), and no more handles than M has cells of dimension one. Tubes around degenerate curves
/// are balls that meet two faces: they add nothing to the former.
///
/// Critical points are enclosed in intervals of doubles, and what may be one must be certain to be,
/// or to be on the other side, or not to count.
///
/// @param side  1 to count larger modes, -1 smaller ones
/// @pre the curve of mode `side` meets the tetrahedron in arcs from inside a face to inside a face,
///      across both, or not at all
/// @return nothing if some critical point is not certain
std::optional<LevelCount> count_level(const CellCriticalPoints& points, const ModeValue& mode,
                                      int side);

/// By how much the counts change from one level to another: what the critical points between the
/// two add, those of `count_level` on one side of the one less those of the other.
///
/// With what is known of a level far from the degenerate curves this gives the count of one next
/// to a curve, where that side's own curve, or an edge or a plane of symmetry that it follows,
/// leaves `count_level` without an answer.
///
/// @param from  closer to the end of the side than `mode` is
/// @param side  as above
/// @pre the deviator vanishes nowhere in the tetrahedron
/// @return nothing if some critical point is not certain; `bridges` of those between only
std::optional<LevelCount> count_change(const CellCriticalPoints& points, const ModeValue& from,
                                       const ModeValue& mode, int side);

}  // namespace tensortopo
