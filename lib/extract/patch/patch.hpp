// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "extract/topology/cell_topology.hpp"

namespace tensortopo {

/// A vertex on the boundary of the tetrahedron, as the sheets use it.
struct BoundaryVertex {
  std::int32_t id = -1;  ///< in the output
  std::uint8_t faces = 0;
  Vector3<double> position;
  Vector3<double> medium;    ///< unit medium eigenvector, sign arbitrary
  Vector3<double> dominant;  ///< unit dominant eigenvector, sign arbitrary
};

/// Triangles of one tetrahedron's sheets. A corner c >= 0 is the output's vertex c, c < 0 the
/// inner vertex -1 - c.
template <class Scalar>
struct Patch {
  std::vector<InnerVertex<Scalar>> inner;
  std::vector<std::array<std::int32_t, 3>> triangles;
  /// If it was made from the subdivision of the proof: cells in which a triangle is at 90 degrees
  /// to the gradient or more.
  std::vector<std::uint32_t> cells_against;
};

/// The vertices along the arcs of a tetrahedron's faces, in the final sampling.
struct ArcVertices {
  std::vector<BoundaryVertex> vertices;  ///< ends included unless the arc is closed
  std::vector<double> places;            ///< one for each vertex
};
using FaceArcVertices = std::array<std::vector<ArcVertices>, 4>;

/// The vertices of a boundary loop, in its direction.
std::vector<BoundaryVertex> loop_vertices(const BoundaryLoop& loop,
                                          const FaceArcVertices& vertices);

}  // namespace tensortopo
