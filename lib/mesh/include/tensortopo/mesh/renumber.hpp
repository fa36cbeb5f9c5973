// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// Gives the vertices and tetrahedra of the mesh other numbers in what a surface says of them:
/// vertex v becomes vertices[v], tetrahedron t becomes tets[t]. The surface's own vertices and
/// triangles keep their numbers. Numbers of edges and faces, which count within one extraction, stay.
///
/// Law       With the inverse permutations all is again what it was.
void renumber(SurfaceMesh& surface, std::span<const TetMesh::Index> vertices,
              std::span<const TetMesh::Index> tets);

/// The same of curves.
void renumber(CurveMesh& curves, std::span<const TetMesh::Index> vertices,
              std::span<const TetMesh::Index> tets);

}  // namespace tensortopo
