// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo {

/// Where a mesh is torn: pairs of outer faces that lie in one plane, with tetrahedra on its two
/// sides, and have more than edges in common.
///
/// Such are both sides of a crack of copied vertices, the triangles of a quadrilateral that is cut
/// along its two diagonals, and those around a hanging node. The field has no reason to be
/// continuous there, and the triangles of a surface end. Decided exactly, of the coordinates as
/// they are: what rounding has moved out of the plane leaves a gap, and is not found.
///
/// @param outer of this mesh, as `validate` gives them
/// @return pairs of positions in `outer`, the smaller first, ascending
/// Cost      some 2 us for each outer face.
std::vector<std::array<std::size_t, 2>> unmatched_faces(const TetMesh& mesh,
                                                        std::span<const OuterFace> outer);

}  // namespace tensortopo
