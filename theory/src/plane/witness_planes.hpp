// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "plane/plane.hpp"

namespace tensortopo::theory {

/// A planar field T_0 + x T_x + y T_y with integers, and a triangle in its plane.
struct WitnessPlane {
  std::string name;
  std::array<SymmetricTensor<Rational>, 3> tensors;
  std::array<std::array<Rational, 2>, 3> corners;

  /// The field of the triangle.
  TriangleField<Rational> face() const;
  /// The tensors themselves as those of a triangle: at the origin of weights, and two more. Weights
  /// of sum zero are then no longer those at infinity.
  TriangleField<Rational> span() const;
};

/// Mode 3 sqrt(3) x y / (1 + x^2 + y^2)^(3/2): extrema at (1, 1), (-1, -1), (1, -1) and (-1, 1),
/// saddles at the origin and at infinity in the directions of the axes.
const WitnessPlane& off_diagonal();
/// The same plane with the extremum (1, 1) as its first tensor.
const WitnessPlane& off_diagonal_shifted();
/// Tensors with a common eigenvector, and mode 1 along the circle of radius three.
const WitnessPlane& ring();
/// The ring, slightly changed to three maxima around a minimum, with saddles between them.
const WitnessPlane& three_fold_ring();
/// The ring, slightly changed to one maximum and one saddle next to the minimum.
const WitnessPlane& ring_with_two_extrema();
/// Three extrema, one of which is not degenerate.
const WitnessPlane& smooth_maximum();

}  // namespace tensortopo::theory
