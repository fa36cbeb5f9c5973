// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

/// Tetrahedra with a sheet whose boundary consists of closed curves in faces, each of which the
/// triangles' boundary is not proved to cover.
///
/// Such a boundary has no crossing to hold on to. But if the polygon of the triangles winds once
/// around a point of the face from which it stays farther than its reaches, then so does whatever
/// of the level the segments over it hold, which is therefore the whole of a closed curve: the map
/// from the triangles' boundary to the level's has degree one, as `prove_distance` needs.
///
/// @param reach  of each vertex of the surface
std::vector<TetMesh::Index> uncovered_closed_loops(const SurfaceMesh& surface,
                                                   std::span<const std::size_t> triangles,
                                                   const LevelTopology& topology,
                                                   std::span<const int> reach);

}  // namespace tensortopo
