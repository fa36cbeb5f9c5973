// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "extract/curves/points/exact_direction.hpp"
#include "tensortopo/extract/curve_points.hpp"

namespace tensortopo {

/// The dominant directions of all degenerate tensors that three independent ones span.
struct PlaneDirections {
  /// The isolated ones, each in a set apart from the others.
  std::vector<ExactDirection> points;
  /// An eigenvector that all the tensors share: the directions across it belong to degenerate
  /// tensors as well, and it is the only isolated one.
  std::optional<Vector3<Rational>> axis;
  /// Whether this is all of them; else 150 digits do not separate some.
  bool settled = false;
};

/// Decided in rationals, by the pencil of the two quadratic forms that vanish there.
///
/// Where det(x M + y N) has no double zero the forms meet in simple points. A double zero is
/// rational, and its form, having trace zero, a pair of real lines: their points on another form
/// of the pencil are square roots in square roots. If all forms are singular, they either are
/// products with one linear form, that of the axis, or map one vector to zero, which then is the
/// only direction.
PlaneDirections plane_directions(const std::array<ScaledTensor, 3>& tensors);

}  // namespace tensortopo
