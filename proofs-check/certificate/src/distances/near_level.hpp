// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "claims/compare_level.hpp"
#include "claims/containment.hpp"

namespace certificate {

/// Are triangles and level within a distance of each other in one tetrahedron, both ways? Shown by
/// some points of the triangles, from which no other one is farther than half of the distance:
///
/// - two points of the tetrahedron are within the other half from each of these, on different
///   sides, so that the level crosses the segment between them;
/// - the tetrahedron is cut until each part is clear of the level, or its corners are all within
///   the distance of one of these points (then all of it is, as balls are convex).
///
/// Nothing is asked of what the triangles are like. Places are rounded, by no more than 2^-47 of
/// the largest coordinates: that is taken off the distance first.
/// @pre no corner of the tetrahedron is isotropic
/// @param work  how much that took is added to it
/// @return false if that does not close, or takes too much work
bool is_near_level(const LevelCase& c, std::size_t tet,
                   const std::vector<std::array<Point3, 3>>& triangles, double distance,
                   std::size_t& work);

/// A point of the triangles that is farther from the level in the tetrahedron, as all of it that is
/// not farther is clear of the level; if one is found.
std::optional<Point3> point_far_from_level(const LevelCase& c, std::size_t tet,
                                           const std::vector<std::array<Point3, 3>>& triangles,
                                           double distance);

}  // namespace certificate
