// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "extract/subdivision/refinement.hpp"

namespace tensortopo {

/// The level in a tetrahedron as marching tetrahedra mesh it on a refinement into simple
/// tetrahedra: a mesh whose topology is proved to be the level's.
struct SubdivisionMesh {
  struct Node {
    std::uint32_t first, second;  ///< refinement vertices of the crossed edge, first < second
    /// Bit f is set if the node lies on the face opposite vertex f of the tetrahedron.
    std::uint8_t faces;
  };
  struct Polygon {
    std::uint32_t cell;                    ///< cell of the refinement
    int size = 0;                          ///< 3 or 4
    std::array<std::uint32_t, 4> nodes{};  ///< counter-clockwise seen from the larger mode
    int component = 0;
  };
  struct Component {
    int euler_characteristic = 0;
    std::vector<int> boundary_loops;
  };

  std::vector<Node> nodes;
  std::vector<Polygon> polygons;
  std::vector<Component> components;
  /// Boundary cycles on the faces of the tetrahedron, as nodes in the direction that has the sheet
  /// on the left.
  std::vector<std::vector<std::uint32_t>> boundary_loops;
};

template <class Scalar>
SubdivisionMesh subdivision_mesh(const Refinement<Scalar, 4>& refinement);

}  // namespace tensortopo
