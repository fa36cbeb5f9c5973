// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "tensortopo/scalar/sign.hpp"

namespace tensortopo {

/// The link of a point in a tetrahedral mesh, a sphere or, on the boundary, a disc, with the signs
/// of the mode less its value at the point, next to the point.
struct SignedLink {
  std::vector<Verdict> signs;                 ///< one a vertex of the link
  std::vector<std::array<int, 3>> triangles;  ///< on each the sign is that of a linear function
};

/// The connected parts of a link with one strict sign, each as its vertices, ascending; in order of
/// their first vertices.
std::vector<std::vector<int>> parts_of_sign(const SignedLink& link, Verdict sign);
/// Of each of these parts, whether it has a vertex on the link's boundary, if it has one: then it
/// reaches the boundary of the mesh.
std::vector<char> parts_on_boundary(const SignedLink& link,
                                    const std::vector<std::vector<int>>& parts);

/// What becomes of the level next to a point as the mode passes the point's.
enum class LocalChange {
  regular,    ///< nothing: the level only moves
  birth,      ///< a sheet appears
  death,      ///< a sheet vanishes
  join,       ///< sheets are joined: by a tube, or on the boundary by a strip
  split,      ///< a sheet is torn into several
  open,       ///< on the boundary: a hole opens in a sheet
  close,      ///< on the boundary: a hole of a sheet closes
  other,      ///< something else, see the Euler characteristic
  undecided,  ///< not known; it may be nothing
};

std::string_view name_of(LocalChange change);

/// The least and the most by which a number grows.
struct GrowthBounds {
  /// Both included; negative where it shrinks.
  int least = 0, most = 0;
};

/// The change, and by how much the level's Euler characteristic grows.
struct LocalEffect {
  LocalChange change = LocalChange::undecided;  ///< what happens
  int euler_change = 0;                         ///< unless undecided
  bool on_boundary = false;                     ///< of the mesh
  /// What a link can tell of all of the level: its pieces next to the point, b before and a
  /// after, may or may not hang together elsewhere. So the number of components grows by
  /// min(1, a) - b at least and a - min(1, b) at most, and that of boundary loops in the same way
  /// with arcs (or closed curves) in the place of pieces. Unless undecided.
  GrowthBounds components, boundary_loops;
};

/// What stratified Morse theory says of a link: next to the point the level below is the part of
/// the link with negative signs, F-, and the level above is F+, both with the same boundary inside.
/// So the Euler characteristic grows by that of F+ less that of F-; and nothing changes if both are
/// discs (which on the boundary of the mesh meet it in one arc each).
/// Undecided if a sign is not strict, or the link neither a sphere nor a disc.
LocalEffect local_effect(const SignedLink& link);

}  // namespace tensortopo
