// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "tensortopo/mesh/box_tree.hpp"
#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// Triangles between places in a list of points.
using PatchTriangle = std::array<std::uint32_t, 3>;

namespace detail {

/// A triangle, the box around it and its plane.
struct Side {
  PatchTriangle places;
  std::array<Vector3<double>, 3> corners;
  std::array<double, 3> low, high;
  Vector3<double> normal;
  /// Of a product with the normal, for a vector of length 1 in the largest coordinate.
  double error;
  bool has_area;
};

/// Six products of three differences: each of these has one rounding, a product two, sums five at
/// most, which is less than 64 roundings of the product of the largest coordinates. Products below
/// the smallest doubles lose less than the last term, those of a normal less than
/// `kNormalUnderflow` in each coordinate, which the vector then multiplies.
inline constexpr double kRoundings = 64 * 0x1p-53, kUnderflow = 0x1p-1000,
                        kNormalUnderflow = 0x1p-1070;

inline double largest(const Vector3<double>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

Side side_of(std::span<const Vector3<double>> points, const PatchTriangle& t);

/// Corners that are the same vertex.
enum class Same { place, number };

/// Whether two triangles with an area have more in common than the vertices and the edge that they
/// share, exactly.
template <Same same>
bool intersect(const Side& first, const Side& second);

/// The same for corners at one place, which count as one vertex; false for triangles without area.
bool are_in_conflict(const Side& first, const Side& second);

}  // namespace detail
}  // namespace tensortopo
