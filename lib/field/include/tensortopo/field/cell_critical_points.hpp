// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/field/critical_points.hpp"

namespace tensortopo {

/// All critical points of the mode on a tetrahedron: what `critical_gaps`, `count_level` and
/// `count_change` answer from, for any level.
struct CellCriticalPoints {
  /// At the vertices, inside the edges, inside the faces, inside the tetrahedron. Degenerate
  /// tensors inside faces and inside the tetrahedron are left out. Each knows its derivative
  /// towards the other vertices of the tetrahedron.
  std::array<std::vector<CriticalPoint>, 4> of_dimension;
  /// The deviators at the vertices are linearly independent: the deviator vanishes nowhere.
  bool are_independent = false;
};

/// @param tensors  at the vertices, with nonzero deviators
CellCriticalPoints cell_critical_points(const std::array<SymmetricTensor<double>, 4>& tensors);

}  // namespace tensortopo
