// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/mode_shape.hpp"

#include <cmath>

namespace tensortopo::detail {

using Eigen::Matrix3d;

Matrix3d matrix_of(const Deviator<double>& t) {
  const auto s = thrice(t);
  return Matrix3d{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}};
}

// The mode is sqrt(2) Q / P^(3/2), with P = tr A^2 / 3 and Q = tr A^3 / 3 of A = 3 T.
ModeShape mode_shape(const Matrix3d& tensor, const std::array<Matrix3d, 3>& directions) {
  const double p = tensor.squaredNorm() / 3, scale = std::sqrt(2.0 / p) / p;
  const Matrix3d square = tensor * tensor;
  const double q = square.cwiseProduct(tensor).sum() / 3;
  Eigen::Vector3d p_slope, q_slope;
  for (int i = 0; i < 3; ++i) {
    const auto& d = directions[static_cast<std::size_t>(i)];
    p_slope[i] = 2 * tensor.cwiseProduct(d).sum() / 3;
    q_slope[i] = square.cwiseProduct(d).sum();
  }
  ModeShape shape{scale * q, scale * (q_slope - 1.5 * q / p * p_slope), {}};
  for (int i = 0; i < 3; ++i) {
    const auto& d = directions[static_cast<std::size_t>(i)];
    const Matrix3d product = tensor * d;
    for (int j = 0; j < 3; ++j) {
      const auto& e = directions[static_cast<std::size_t>(j)];
      const double p_hessian = 2 * d.cwiseProduct(e).sum() / 3;
      const double q_hessian = (product + product.transpose()).cwiseProduct(e).sum();
      const double mixed = q_slope[i] * p_slope[j] + q_slope[j] * p_slope[i];
      shape.hessian(i, j) = scale * (q_hessian - 1.5 / p * (mixed + q * p_hessian) +
                                     3.75 * q / (p * p) * p_slope[i] * p_slope[j]);
    }
  }
  return shape;
}

}  // namespace tensortopo::detail
