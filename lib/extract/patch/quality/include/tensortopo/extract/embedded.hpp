// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// Whether the triangles of a surface are embedded: each has an area, and any two of them meet in
/// the vertices and the edge that they share only, whichever tetrahedra they belong to. Decided
/// exactly for the coordinates as they are; two vertices at one place are no embedding. This is
/// what the key `embedded` of a certificate claims.
bool is_embedded(const SurfaceMesh& surface);

/// The tetrahedra in which two triangles intersect beyond the vertices and the edge that they share
/// (vertices at one place count as one here), or one is at 90 degrees or more to the gradient of the
/// mode at its centroid: what `Extraction::not_embedded` lists, of triangles that were changed since.
/// Tetrahedra where the mode is undefined at a corner are left out, as there.
/// @return positions in the mesh, ascending
std::vector<TetMesh::Index> tets_not_embedded(const TetMesh& mesh, const SurfaceMesh& surface);

}  // namespace tensortopo
