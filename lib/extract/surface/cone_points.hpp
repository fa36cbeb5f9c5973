// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// Gives the triangles that meet at isotropic vertices of the mesh vertices of their own there, one
/// for each fan.
///
/// A triangle with two such vertices is first cut in two at a point halfway between them, which it
/// has in common with the triangle of the same sector. Then two triangles that share one more
/// vertex besides an isotropic one share that one as well, and no others do: the triangles
/// around each become one fan.
///
/// Works on `points`, `triangles` and `tet` alone; new vertices come after all others.
/// @param is_zero  of each vertex: it is isotropic; grows with the points
/// @param sector   of each triangle, -1 unless it has two of them
/// @return for each new vertex, the vertices that it is a copy of (twice the same) or lies between
std::vector<std::array<SurfaceMesh::Index, 2>> separate_fans(
    SurfaceMesh& surface, std::vector<char>& is_zero, std::span<const SurfaceMesh::Index> sector);

}  // namespace tensortopo
