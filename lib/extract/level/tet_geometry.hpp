// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tensortopo/scalar/power_of_two.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// A power of two that brings the longest side of the box around the points to between 1 and 2: in
/// this unit no product of lengths overflows.
inline double unit_of(const std::array<Vector3<double>, 4>& points) {
  auto low = points[0], high = points[0];
  for (const auto& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto side = high - low;
  return times_power(1, -floor_log2(std::max({side.x, side.y, side.z})));
}

/// The linear field of a tetrahedron in space: barycentric coordinates from a position.
class TetGeometry {
 public:
  /// @param exponents of the scaled tensors, see `ScaledField`
  TetGeometry(const std::array<Vector3<double>, 4>& points, const std::array<int, 4>& exponents)
      : points_(points), exponents_(exponents) {
    // Gradient of coordinate i: the inward normal of the face opposite i over six volumes.
    constexpr std::array<std::array<std::size_t, 3>, 4> inward{
        {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& p = points_[inward[i][0]];
      const auto n = cross(points_[inward[i][1]] - p, points_[inward[i][2]] - p);
      six_volumes_ = dot(n, points_[i] - p);
      gradient_[i] = (1 / six_volumes_) * n;
    }
    // T_i = 2^-exponent U_i; a common power of two keeps the largest at U's scale.
    const int least = *std::min_element(exponents.begin(), exponents.end());
    for (std::size_t i = 0; i < 4; ++i) scale_[i] = times_power(1, least - exponents[i]);
  }

  /// Barycentric coordinate i, from a fixed vertex of the opposite face: the error is small beside
  /// the distance from that vertex, in parts of the tetrahedron's size, but not always beside the
  /// coordinate itself.
  double weight(std::size_t i, const Vector3<double>& x) const {
    return dot(gradient_[i], x - points_[i == 0 ? 1 : 0]);
  }

  const Vector3<double>& weight_gradient(std::size_t i) const { return gradient_[i]; }

  /// The field at some weights, up to a positive factor.
  Deviator<double> tensor(const std::array<double, 4>& weights,
                          const std::array<Deviator<double>, 4>& scaled) const {
    Deviator<double> t{};
    for (std::size_t i = 0; i < 4; ++i) t = t + (weights[i] * scale_[i]) * scaled[i];
    return t;
  }

  /// The field at a position, up to the same factor.
  Deviator<double> tensor(const Vector3<double>& x,
                          const std::array<Deviator<double>, 4>& scaled) const {
    return tensor({weight(0, x), weight(1, x), weight(2, x), weight(3, x)}, scaled);
  }

  /// The same, times a power of two that brings its largest coordinate between 1/2 and 2; zero
  /// stays. Where tensors at the corners differ by hundreds of orders of magnitude, the forms of
  /// the field in one scale underflow.
  Deviator<double> balanced_tensor(const Vector3<double>& x,
                                   const std::array<Deviator<double>, 4>& scaled) const {
    std::array<double, 4> weights;
    for (std::size_t i = 0; i < 4; ++i) weights[i] = weight(i, x);
    // At a corner itself roundoff in the other weights may be more than all that it has.
    for (std::size_t i = 0; i < 4; ++i)
      if (x == points_[i]) weights = {}, weights[i] = 1;
    int largest = std::numeric_limits<int>::min();
    for (std::size_t i = 0; i < 4; ++i)
      if (weights[i] != 0) largest = std::max(largest, floor_log2(weights[i]) - exponents_[i]);
    Deviator<double> t{};
    for (std::size_t i = 0; i < 4; ++i)
      if (weights[i] != 0) t = t + times_power(weights[i], -exponents_[i] - largest) * scaled[i];
    double size = 0;
    for (const double c : {t.a, t.b, t.xy, t.yz, t.xz}) size = std::max(size, std::abs(c));
    if (size == 0) return t;
    const int shift = -floor_log2(size);
    const auto shifted = [&](double c) { return times_power(c, shift); };
    return {shifted(t.a), shifted(t.b), shifted(t.xy), shifted(t.yz), shifted(t.xz)};
  }

  /// Gradient, in space, of a function with this slope in the tensor.
  Vector3<double> gradient(const SymmetricTensor<double>& slope,
                           const std::array<Deviator<double>, 4>& scaled) const {
    Vector3<double> g;
    for (std::size_t i = 0; i < 4; ++i)
      g += (scale_[i] * inner(slope, thrice(scaled[i]))) * gradient_[i];
    return g;
  }

  double longest_edge() const {
    double longest = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const auto e = points_[j] - points_[i];
        longest = std::max(longest, length(e));
      }
    return longest;
  }

  /// A bound on the error of `weight`, for positions not farther away than the tetrahedron is wide.
  /// Differences of coordinates have one rounding each; a weight is a determinant of three of them
  /// over one of three others, both with fewer than 32 roundings of terms below the cube of the
  /// longest edge.
  double weight_error() const {
    const double length = longest_edge();
    constexpr double kRoundoff = 0x1p-53;
    return 64 * kRoundoff * (length * length * length / std::abs(six_volumes_));
  }

 private:
  std::array<Vector3<double>, 4> points_;
  std::array<int, 4> exponents_;
  std::array<Vector3<double>, 4> gradient_;
  std::array<double, 4> scale_;
  double six_volumes_ = 0;
};

}  // namespace tensortopo
