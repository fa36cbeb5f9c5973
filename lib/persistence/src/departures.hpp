// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/field/mode_along_segments.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/sweep/mesh_critical_values.hpp"
#include "vertex_stars.hpp"

namespace tensortopo::persistence {

/// A way to leave a critical point in a tetrahedron.
struct TetDeparture {
  TetMesh::Index tet = -1;
  Departure departure;
};

/// For each part of the link of a critical point in which the mode is larger: ways from the point
/// into it.
/// @pre the point is certain
std::vector<std::vector<TetDeparture>> departures(const TetMesh& mesh, const VertexStars& stars,
                                                  const MeshCriticalPoint& point);

/// The vertices of a tetrahedron, or the tensors there.
TetTensors4 tensors_of(const TetMesh& mesh, TetMesh::Index tet);

}  // namespace tensortopo::persistence
