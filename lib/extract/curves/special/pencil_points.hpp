// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "extract/curves/points/exact_direction.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

/// A degenerate tensor x A + y B with positive x and y.
struct PencilPoint {
  std::array<Extended, 2> weights{};  ///< x and y over their sum, rounded
  bool linear = true;
  ExactDirection direction;
};

/// All degenerate tensors strictly between two independent ones; at most three. Nothing if 150
/// digits do not tell their kinds.
///
/// T is degenerate exactly if the deviator of T^2 is a multiple of T. The ten minors of these two
/// are cubics along the segment, so that the points sought are the zeros of their greatest common
/// divisor, which rationals find; where it has degree three the tensors commute.
std::optional<std::vector<PencilPoint>> degenerate_points_between(const Deviator<Rational>& a,
                                                                  const Deviator<Rational>& b);

/// The dominant directions of all degenerate tensors that two independent ones span, each in a set
/// apart from the others; nothing if 150 digits do not separate two.
std::optional<std::vector<ExactDirection>> pencil_directions(const Deviator<Rational>& a,
                                                             const Deviator<Rational>& b);

}  // namespace tensortopo
