// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace proofs {

/// A square of the top face of the cube by its lower corner.
struct TopSquare {
  int x, y;
};

/// What cutting and gluing makes of the sphere.
struct GluedSurface {
  long vertices = 0, edges = 0, faces = 0;
  bool closed = false;  ///< each edge in two faces, and the faces at each vertex in one cycle
  bool connected = false;
  bool orientable = false;
  long euler_characteristic() const { return vertices - edges + faces; }
};

/// The surface of the cube [0, n]^3 in unit squares, which is a sphere; without the squares named
/// of its top, no two of which are joined by an edge, and their antipodes; the boundary of what is
/// left glued to itself by the antipodal map.
GluedSurface glue_antipodes(int n, const std::vector<TopSquare>& removed);

}  // namespace proofs
