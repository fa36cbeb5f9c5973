// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/subdivision/hessian_metric.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "extract/level/mode_shape.hpp"
#include "extract/level/proofs/tiers.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo::detail {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// Corners 1 to 3 of a regular tetrahedron, from corner 0.
Matrix3d regular_corners() {
  return Matrix3d{
      {1, 0.5, 0.5}, {0, std::sqrt(0.75), std::sqrt(1.0 / 12)}, {0, 0, std::sqrt(2.0 / 3)}};
}

}  // namespace

template <class Scalar>
std::array<double, 6> hessian_lengths(
    const std::array<const RefinementVertex<Scalar, 4>*, 4>& corners) {
  // Coordinates of the corners are homogeneous; the field is linear where they have the sum 1.
  std::array<Matrix3d, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& w = corners[i]->weights;
    tensors[i] =
        matrix_of(rounded(std::array{corners[i]->tensor})[0]) / (w[0] + w[1] + w[2] + w[3]);
  }
  const Matrix3d middle = (tensors[0] + tensors[1] + tensors[2] + tensors[3]) / 4;
  const auto shape = mode_shape(
      middle, {tensors[1] - tensors[0], tensors[2] - tensors[0], tensors[3] - tensors[0]});
  static const Matrix3d regular = regular_corners(), to_cell = regular.inverse();
  const Matrix3d hessian = to_cell.transpose() * shape.hessian * to_cell;
  std::array<double, 6> lengths{};
  if (!hessian.allFinite()) return lengths;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(hessian);
  const auto corner = [&](int i) -> Vector3d {
    return i == 0 ? Vector3d(0, 0, 0) : Vector3d(regular.col(i - 1));
  };
  for (std::size_t e = 0; e < 6; ++e) {
    const Vector3d edge = corner(kTetEdges[e][1]) - corner(kTetEdges[e][0]);
    const Vector3d along = solver.eigenvectors().transpose() * edge;
    lengths[e] = along.cwiseAbs2().dot(solver.eigenvalues().cwiseAbs());
  }
  return lengths;
}

#define TENSORTOPO_INSTANTIATE(Scalar)            \
  template std::array<double, 6> hessian_lengths( \
      const std::array<const RefinementVertex<Scalar, 4>*, 4>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::detail
