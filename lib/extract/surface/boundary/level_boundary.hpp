// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "extract/level/edge_crossing.hpp"
#include "extract/surface/boundary/rows.hpp"
#include "extract/surface/boundary/vertex_sides.hpp"
#include "extract/topology/boundary/cell_boundary.hpp"

namespace tensortopo {

/// The level on the edges: of each edge its crossings in order, unknown where no proof closes.
template <class Scalar>
struct MeshCrossings {
  Rows<EdgeCrossing<Scalar>> rows;
  std::vector<char> moved;  ///< of each edge: these are the crossings of a nearby level
};

/// The level on the edges and faces: of each face the arcs of its mode curves, unknown where no
/// proof closes.
template <class Scalar>
struct LevelBoundary {
  MeshCrossings<Scalar> crossings;
  Rows<FaceArc<Scalar>> arcs;
  std::vector<char> moved;  ///< of each face: these are the arcs of a nearby level, see `FaceArc`
};

}  // namespace tensortopo
