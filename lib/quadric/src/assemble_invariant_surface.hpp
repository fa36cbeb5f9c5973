// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "cell_subdivision.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// One surface from what tetrahedra hold: vertices with the same key are one vertex, first those on
/// edges of the mesh, then on faces, then inside, each kind in the order of its keys. `cells` has a
/// part for each nappe and tetrahedron, `tets` says which; triangles are in their order. There are no
/// normals.
SurfaceMesh assemble_invariant_surface(std::span<const CellLevel> cells,
                                       std::span<const TetMesh::Index> tets, double value);

/// Normals, of a surface with the triangles of these cells in their order: of each vertex the
/// direction of the sum of the unit gradients in the tetrahedra whose triangles meet there, however
/// many each of them has.
void add_normals(std::span<const CellLevel> cells, SurfaceMesh& surface);

}  // namespace tensortopo
