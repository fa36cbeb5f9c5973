// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// Every tetrahedron cut in eight at the midpoints of its edges: a conforming mesh of the same
/// piecewise linear field, up to the rounding of the means.
///
/// The octahedron in the middle is cut along the diagonal between the midpoints of edges 02 and 13.
/// The points of the mesh keep their numbers; `cell_ids` are those of the tetrahedra that were cut.
/// @pre the mesh is valid (see `validate`)
TetMesh subdivide(const TetMesh& mesh);

}  // namespace tensortopo
