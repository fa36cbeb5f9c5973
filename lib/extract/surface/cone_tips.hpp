// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "extract/surface/cells/mesh_cells.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// Adds the vertices of the surface where the mode is undefined: one for each fan at an isotropic
/// vertex of the mesh, and those halfway between two. Marks them all in `is_apex`.
/// @return how many there are
template <class Scalar>
std::size_t add_cone_tips(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                          const TetComplex& cells, const CellMeshes<Scalar>& meshes,
                          SurfaceMesh& surface, std::vector<char>& is_apex);

}  // namespace tensortopo
