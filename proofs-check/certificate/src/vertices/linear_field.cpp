// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vertices/linear_field.hpp"

#include <algorithm>
#include <cmath>

namespace certificate {

LinearField::LinearField(const Input& input, const std::array<Vertex, 4>& tet)
    : origin_(input.points[tet[0]]) {
  double largest = 0, size = 0;
  for (const Vertex v : tet) {
    for (const double x : input.tensors[v]) largest = std::max(largest, std::abs(x));
    for (std::size_t k = 0; k < 3; ++k)
      size = std::max(size, std::abs(input.points[v][k] - origin_[k]));
  }
  if (size > 0) length_ = -std::ilogb(size);
  if (largest > 0) scale_ = std::clamp(-std::ilogb(largest), -1000, 1000);
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Ball, 6> t;  // XX YY ZZ XY YZ XZ
    for (std::size_t k = 0; k < 6; ++k)
      t[k] = Ball(std::ldexp(input.tensors[tet[i]][k], scale_), Ball::kTiny);
    const Ball trace = t[0] + t[1] + t[2], three(3);
    tensors_[i] = {three * t[0] - trace,
                   three * t[1] - trace,
                   three * t[2] - trace,
                   three * t[4],
                   three * t[5],
                   three * t[3],
                   trace,
                   Ball()};
  }
  for (std::size_t i = 0; i < 3; ++i) edges_[i] = from_origin(input.points[tet[i + 1]], {});
  for (std::size_t i = 0; i < 3; ++i) normals_[i] = cross(edges_[(i + 1) % 3], edges_[(i + 2) % 3]);
  volume_ = dot(edges_[0], normals_[0]);
}

Tensor<Ball> LinearField::at(const Point3& x, const Point3& off) const {
  const Vector3<Ball> d = from_origin(x, off);
  Ball rest = volume_;
  Tensor<Ball> sum{};
  const auto add = [&](const Ball& weight, const Tensor<Ball>& t) {
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * t[k];
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Ball weight = dot(normals_[i], d);
    rest -= weight;
    add(weight, tensors_[i + 1]);
  }
  return add(rest, tensors_[0]), sum;
}

Vector3<Ball> LinearField::gradient(const std::array<Ball, 4>& values) const {
  Vector3<Ball> sum{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) sum[k] += (values[i + 1] - values[0]) * normals_[i][k];
  return sum;
}

Vector3<Ball> LinearField::from_origin(const Point3& p, const Point3& off) const {
  Vector3<Ball> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Ball d = Ball(p[k], off[k]) - Ball(origin_[k], 0);
    result[k] = Ball(std::ldexp(d.value, length_), std::ldexp(d.error, length_) + Ball::kTiny);
  }
  return result;
}

}  // namespace certificate
