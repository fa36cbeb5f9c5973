// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "levels/level_surface.hpp"
#include "topology/loop_tetrahedron.hpp"

namespace tensortopo::theory {

/// The mode surface in a tetrahedron with a loop of the complex domain's boundary inside, cut open
/// along the boundary: what is left are the vectors of the surface on the sphere.
struct LoopCut {
  LevelSurface surface;  ///< uncut; certified
  int sheets = 0;        ///< components if cut along the loop
  int arcs = 0;          ///< of the other loop in the surface: 0 or 1
  int pieces = 0;        ///< components if cut along the arc too
  int boundary_loops = 0;          ///< boundary loops then, without the two sides of the loop

  bool has_handle() const { return sheets == surface.components; }
};

/// Exactly. The arcs of the surface in faces, and its points on edges, are a graph whose cycles
/// generate those of the surface, mod 2; a closed curve, or an arc between boundary points,
/// separates it exactly if all cycles cross it an even number of times (`LoopCrossings`). The
/// number of arcs is that of `arcs_of_loop`. Nothing if a budget is exceeded, or if the other loop
/// has more than one arc.
///
/// @param t  the loop on its side has mode mu inside
std::optional<LoopCut> cut_along_loops(const LoopTetrahedron& t);

}  // namespace tensortopo::theory
