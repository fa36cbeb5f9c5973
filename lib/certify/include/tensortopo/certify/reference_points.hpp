// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// The vertices of a mode surface to more digits than a double holds.
struct ReferencePoints {
  /// Decimal coordinates of each vertex, 36 significant digits.
  std::vector<std::array<std::string, 3>> coordinates;
  /// Each vertex but those in `unproved` has a point of the level within this distance.
  double bound = 0;
  /// Vertices for which no signs were found (ascending); their coordinates are those given.
  std::vector<SurfaceMesh::Index> unproved;
};

/// Moves each vertex onto the level, within the edge, face or tetrahedron that holds it, along the
/// gradient of the mode with respect to barycentric coordinates.
///
/// Proof: the result's barycentric coordinates w are multiples of 2^-120 and d a direction with
/// largest entry 1; in rationals, the mode is larger than mu at one of w - 2^-108 d, w + 2^-108 d
/// and smaller at the other, and both are in the simplex, so the segment between them meets the
/// level. `bound` is 2^-106 of the largest simplex plus the rounding of the decimals. Where the
/// mode is undefined (`Carrier::vertex`) vertices stay in place, unproved.
/// @pre `surface` is an extraction of mode `mode` from `mesh`
ReferencePoints reference_points(const TetMesh& mesh, const SurfaceMesh& surface,
                                 const ModeValue& mode);

}  // namespace tensortopo
