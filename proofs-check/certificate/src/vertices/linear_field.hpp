// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "claims/containment.hpp"
#include "curves/conics.hpp"
#include "files/files.hpp"
#include "topology.hpp"

namespace certificate {

/// @pre b is positive
inline Ball quotient(const Ball& a, const Ball& b) {
  const double v = a.value / b.value;
  const double least = (b.value - b.error) / Ball::kSlack;
  return {v, ((a.error + std::abs(v) * b.error) / least + std::abs(v) * (2 * Ball::kUnit) +
              Ball::kTiny) *
                 Ball::kSlack};
}

/// Infinite where it may be of a negative number.
inline Ball square_root(const Ball& x) {
  if (!(x.value > x.error)) return {0, HUGE_VAL};
  const double v = std::sqrt(x.value);
  return {v, (x.error / v + v * (2 * Ball::kUnit) + Ball::kTiny) * Ball::kSlack};
}

/// The linear field of a tetrahedron, enclosed.
class LinearField {
 public:
  LinearField(const Input& input, const std::array<Vertex, 4>& tet);

  double unit() const { return std::ldexp(1.0, -scale_); }
  /// Six times that of the tetrahedron, in the order of its vertices, in a unit of its size.
  const Ball& volume() const { return volume_; }
  /// Three times the deviator and the trace at a place, times `volume`, in units of `unit`.
  /// @param off  how far the place may be from x, on each axis
  Tensor<Ball> at(const Point3& x, const Point3& off = {}) const;
  /// Three times the deviator and the trace at a corner.
  const Tensor<Ball>& corner(std::size_t i) const { return tensors_[i]; }
  /// Of a function that has these values at the corners and is linear, times `volume`, up to a
  /// positive factor.
  Vector3<Ball> gradient(const std::array<Ball, 4>& values) const;

 private:
  Vector3<Ball> from_origin(const Point3& p, const Point3& off) const;

  Point3 origin_;
  std::array<Tensor<Ball>, 4> tensors_;
  std::array<Vector3<Ball>, 3> edges_, normals_;
  Ball volume_;
  int length_ = 0, scale_ = 0;
};

}  // namespace certificate
