// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "tensortopo/field/deviator_box.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// A point of a tetrahedron: homogeneous barycentric weights, not negative, taken as exact numbers.
using TetWeights = std::array<double, 4>;
using TetTensors4 = std::array<SymmetricTensor<double>, 4>;

/// The deviator of the linear field at a point, enclosed.
DeviatorBox deviator_box(const TetTensors4& tensors, const TetWeights& weights);

/// The mode in a box, enclosed in [low, high], within [-1, 1].
std::array<double, 2> mode_range(const DeviatorBox& box);

/// Proves that the mode is larger than `level` at each point of the segment from a point to another
/// one, for all deviators in the two boxes.
/// @return false if it is not, or intervals of doubles on `most_parts` parts do not show it
bool is_mode_above(const DeviatorBox& from, const DeviatorBox& to, double level,
                   int most_parts = 256);

/// A critical point or a vertex of the mesh in a tetrahedron, and a direction in which to leave it.
struct Departure {
  DeviatorBox deviator;  ///< there
  TetWeights weights{};  ///< about where
  TetWeights towards{};  ///< a vertex (one weight 1), or a direction, of sum 0
  /// The mode's derivative in the direction is known to vanish: then the second one is looked at.
  bool is_critical = false;
};

/// A point to which the mode rises strictly from the given one, without interruption, along a
/// segment; but for a last part, shorter than rounding, on which it is above `level`.
///
/// The mode rises as long as the cubic 2 P Q' - 3 Q P' is positive (`critical_points_on_edge`).
/// @param level  at least the mode at the given point
/// @return the weights of the point; nothing if intervals of doubles prove no rise
std::optional<TetWeights> rise_from(const TetTensors4& tensors, const Departure& departure,
                                    double level);

}  // namespace tensortopo
