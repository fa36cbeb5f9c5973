// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "topology/level_surface.hpp"
#include "topology/loop_tetrahedron.hpp"

namespace tensortopo::theory {

/// The mode surface in a tetrahedron with a loop of the complex domain's boundary inside, cut open
/// along the boundary: what is left are the vectors of the surface on the sphere.
struct LoopCut {
  LevelSurface surface;  ///< uncut; certified
  int sheets = 0;        ///< components if cut along the loop
  int arcs = 0;          ///< of the other loop in the surface: 0 or 1
  int pieces = 0;        ///< components if cut along the arc too
  int rims = 0;          ///< boundary loops then, without the two sides of the loop

  bool has_handle() const { return sheets == surface.components; }
};

/// The surface is a certified complex of discs. Where the boundary cuts their sides is found in
/// doubles: the medium eigenvector is carried along each side, in a triangle without degenerate
/// points, and compared with that of sigma <= 0 at the end. Nothing if a budget is exceeded, if
/// the other loop has more than one arc, or if cuts are not resolved.
///
/// @param t  the loop on its side has mode mu inside
std::optional<LoopCut> cut_along_loops(const LoopTetrahedron& t);

}  // namespace tensortopo::theory
