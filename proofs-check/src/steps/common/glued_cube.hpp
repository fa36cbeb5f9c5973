// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace proofs {

/// A square of the top face of the cube by its lower corner.
struct TopSquare {
  int x, y;
};

/// What cutting and gluing makes of the sphere.
struct GluedSurface {
  long vertices = 0, edges = 0, faces = 0;
  bool is_manifold = false;  ///< each edge in one or two faces, and the faces at each vertex joined
  int boundary_edges = 0;    ///< in one face
  int boundary_loops = 0;
  int components = 0;
  bool orientable = false;
  long euler_characteristic() const { return vertices - edges + faces; }
};

/// Whether a square of the cube, by its lowest corner and the axis across it, is left out.
using IsLeftOut = std::function<bool(const std::array<int, 3>& lowest, std::size_t axis)>;

/// The surface of the cube [0, n]^3 in unit squares, which is a sphere; without the squares named
/// of its top, no two of which are joined by an edge, and their opposites; their boundaries glued
/// by p -> opposite of p. Other squares can be left out too, whose boundaries stay.
///
/// @param kept  how many of the first coordinates the opposite keeps: none for the antipodal map;
///              one for a half turn, by which the surface is glued wrongly
GluedSurface glue_opposites(int n, const std::vector<TopSquare>& removed, int kept,
                            const IsLeftOut& left_out = {});

}  // namespace proofs
