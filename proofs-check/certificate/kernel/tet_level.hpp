// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The level in a tetrahedron of the mesh.
#pragma once

#include "face_level.hpp"

namespace certificate {

/// A closed curve of the level on the boundary of a tetrahedron, by a crossing on it, or by its
/// number in the face of which it is a closed curve.
struct RimCurve {
  unsigned simplex = 0;  ///< a bit for each corner of the edge or face
  std::size_t number = 0;
};
struct Sheet {
  long euler_characteristic = 0;
  std::vector<std::size_t> loops;  ///< which of the closed curves
  bool above_inside = false;       ///< of a sheet without loops: what it encloses is above
};

/// What is known of a tetrahedron's faces and edges.
struct TetBoundary {
  std::array<const EdgeLevel*, 6> edges{};  ///< 01, 02, 12, 03, 13, 23, as `for_subsets` goes
  std::array<const FaceLevel*, 4> faces{};  ///< by the opposite corner
};

/// The sheets of a tetrahedron, by the closed curves on its boundary. Nothing if no proof closes.
///
/// It is cut into monotone and empty cells, whose edges and faces are settled each by itself.
/// The level leaves regions of these, and what touches is joined; so a part of the level is known
/// by the region below it and that above it: two regions of a ball have one sheet between them.
/// Euler characteristics are counted: 1 for a crossing, -1 for an open arc, and for an open piece
/// in a cell, which is planar, 2 less the number of its boundary curves.
std::optional<std::vector<Sheet>> level_in_tet(const Level& level,
                                               const std::array<Corner, 4>& corners,
                                               const Proved<4>& proved,
                                               const TetBoundary& boundary,
                                               const std::vector<RimCurve>& curves);

}  // namespace certificate
