// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "support/surfaces/topology.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// Components of {mode = m} as marching tetrahedra see them on `cube_mesh(cubes)` with every edge
/// cut into `parts`: the cube mesh of smaller cubes refines the larger one, and the field stays the
/// piecewise linear one of the larger. Combinatorial, on exact signs.
std::vector<ComponentTopology> fine_components(const TetMesh& mesh, int cubes,
                                               const std::string& mode, int parts);

}  // namespace tensortopo::test
