// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "tensortopo/extract/curve_points.hpp"

namespace tensortopo {

/// Bounds of the barycentric coordinates of a point in a triangle.
struct WeightBounds {
  std::array<double, 3> low{}, high{};
};

/// Bounds, rounded outward, of the barycentric coordinates of a degenerate point in the triangle
/// with the tensors as they were before their powers of two. Mostly narrower than 2^-44.
/// Nothing if 150 digits give none.
/// @param point  as `degenerate_points_on_face` found it for these tensors
std::optional<WeightBounds> weight_bounds(const std::array<ScaledTensor, 3>& tensors,
                                          const FacePoint& point);

}  // namespace tensortopo
