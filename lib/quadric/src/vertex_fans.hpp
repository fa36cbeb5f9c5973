// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// Where parts of a surface meet in a vertex only, as parts of the mesh do in an edge or as
/// tetrahedra were left out, gives each fan of triangles but the first a vertex of its own, after
/// all others.
/// @pre oriented; each edge has at most two triangles
/// @return each such vertex: of which it is a copy, and itself; ascending
std::vector<std::array<SurfaceMesh::Index, 2>> separate_fans(SurfaceMesh& surface);

}  // namespace tensortopo
