// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What a reader can check by hand: exact points of a simplex, and on which side of the level each is.
#pragma once

#include <span>
#include <string>

#include "claims/compare_level.hpp"

namespace certificate {

/// Points of a simplex of the mesh that show how the level meets it, with their sides: the corners,
/// of an edge one point between any two crossings next to each other, of others a point on the
/// other side where all corners are on one. A point is named by weights in proportion to its barycentric
/// coordinates, as in "[17,15] above". Says so if the mesh has no such simplex, or if all
/// tetrahedra with it are left out.
/// @param vertices  2 to 4
std::string sides_in(const LevelCase& c, std::span<const Number> vertices);

/// A point of a face inside each of its closed curves' parts of the face, and beside it: the ends of an
/// edge that the curve crosses.
std::string sides_of_curves(const LevelCase& c, const FaceTopology& face);

}  // namespace certificate
