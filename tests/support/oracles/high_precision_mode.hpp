// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// The linear field of one tetrahedron at one point, evaluated with 50 digits and then rounded.
struct PreciseMode {
  double residual = 0;  ///< mode at the point less the level
  /// What the mode can change when every coordinate moves by half a unit in its last place:
  /// the sum over the axes of |derivative of the mode| times that.
  double rounding = 0;
  double gradient = 0;  ///< length of the gradient of the mode
  /// Barycentric coordinates, and how much each can change by rounding a point of this
  /// tetrahedron whose coordinates are as large as they can be.
  std::array<double, 4> barycentric{}, barycentric_rounding{};
};

PreciseMode precise_mode(const TetMesh& mesh, TetMesh::Index tet, const Vector3<double>& point,
                         double level);

}  // namespace tensortopo::test
