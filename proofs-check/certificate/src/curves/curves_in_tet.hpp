// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// How the degenerate curve of a tetrahedron joins the points in which it meets the faces.
#pragma once

#include <optional>
#include <vector>

#include "curves/degenerate_points.hpp"

namespace certificate {

/// A degenerate point of a tetrahedron's face.
struct BoundaryPoint {
  std::size_t opposite;  ///< the vertex that is not of the face, a place in the tetrahedron
  FacePoint point;
};

/// The pieces of the curve: which two boundary points each joins, as positions in the list. Nothing
/// if that stays open: the tensors are dependent, the curve crosses itself, or signs are not
/// settled.
/// @param boundary  all points on the boundary that are degenerate of the kind, in decided faces
std::optional<std::vector<std::array<std::size_t, 2>>> joined_in_tet(
    const std::array<Corner, 4>& corners, std::vector<BoundaryPoint> boundary, Kind kind);

}  // namespace certificate
