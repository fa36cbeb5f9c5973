// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "numeric_mode.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tensortopo/scalar/power_of_two.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::persistence {

Deviators deviators_of(const TetMesh& mesh, TetMesh::Index tet) {
  const auto& vertices = mesh.tets[as_size(tet)];
  // First the tensors: differences of their components may overflow.
  double largest = 0;
  for (const auto v : vertices) largest = std::max(largest, max_norm(mesh.tensors[as_size(v)]));
  const double factor = inverse_power(largest);
  Deviators corners;
  double largest_left = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = deviator(factor * mesh.tensors[as_size(vertices[i])]);
    for (const double x : {corners[i].a, corners[i].b, corners[i].xy, corners[i].yz, corners[i].xz})
      largest_left = std::max(largest_left, std::abs(x));
  }
  const double rest = inverse_power(largest_left);
  for (auto& corner : corners) corner = rest * corner;
  return corners;
}

Deviator<double> combine(const Deviators& corners, const TetWeights& weights) {
  Deviator<double> sum{};
  for (std::size_t i = 0; i < 4; ++i) sum = sum + weights[i] * corners[i];
  return sum;
}

double angle_of(const Deviator<double>& t) {
  constexpr double kNone = 4;
  const double p = norm_form(t);
  return p > 0 && std::isfinite(p) ? lode_angle(t) : kNone;
}

double derivative(const Deviator<double>& t, const Deviator<double>& u) {
  const auto m = thrice(t);
  return 2 * norm_form(t) * inner(square(m), thrice(u)) - 6 * determinant_form(t) * norm_form(t, u);
}

TetWeights newton_direction(const Deviators& corners, const TetWeights& weights,
                            const std::array<bool, 4>& is_used) {
  constexpr double kStep = 1e-5;  // of tensors whose largest component is about 1
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < 4; ++i)
    if (is_used[i]) used.push_back(i);
  TetWeights direction{};
  if (used.size() < 2) return direction;
  const auto t = combine(corners, weights);
  const auto n = static_cast<Eigen::Index>(used.size() - 1);
  const auto side = [&](Eigen::Index i) {
    return corners[used[static_cast<std::size_t>(i) + 1]] - corners[used[0]];
  };
  // Rows and columns from n on are zero: they add eigenvalues of zero, whose axes no other has part in.
  const auto gradient = [&](const Deviator<double>& at) {
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
    const double p = norm_form(at), power = p * p * std::sqrt(p);
    for (Eigen::Index i = 0; i < n; ++i) g(i) = derivative(at, side(i)) / power;
    return g;
  };
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Eigen::Index j = 0; j < n; ++j)
    second.col(j) = (gradient(t + kStep * side(j)) - gradient(t - kStep * side(j))) / (2 * kStep);
  if (!second.allFinite()) return direction;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver((second + second.transpose()) / 2);
  if (solver.info() != Eigen::Success) return direction;
  const auto& axes = solver.eigenvectors();
  const double largest = solver.eigenvalues().cwiseAbs().maxCoeff();
  if (!(largest > 0)) return direction;
  const Eigen::Vector3d size = solver.eigenvalues().cwiseAbs().cwiseMax(1e-9 * largest);
  const Eigen::Vector3d step = axes * (axes.transpose() * gradient(t)).cwiseQuotient(size);
  for (Eigen::Index i = 0; i < n; ++i) {
    direction[used[static_cast<std::size_t>(i) + 1]] += step(i);
    direction[used[0]] -= step(i);
  }
  return direction;
}

TetWeights direction_of_rise(const Deviators& corners, const TetWeights& weights) {
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < 4; ++i)
    if (weights[i] > 0) used.push_back(i);
  TetWeights direction{};
  if (used.size() < 2) return direction;
  const auto t = combine(corners, weights);
  const auto m = thrice(t), mm = square(m);
  const double p = norm_form(t), q = determinant_form(t);
  const auto side = [&](std::size_t i) { return corners[used[i + 1]] - corners[used[0]]; };
  const auto n = static_cast<Eigen::Index>(used.size() - 1);
  // The largest eigenvalue is wanted if it is positive; rows from n on add eigenvalues of zero.
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto u = side(static_cast<std::size_t>(i)), v = side(static_cast<std::size_t>(j));
      const auto k = thrice(v);
      second(i, j) = 4 * p * p * inner(square(m + k) - mm - square(k), thrice(u)) -
                     12 * p * q * norm_form(u, v) - 12 * q * norm_form(t, u) * norm_form(t, v);
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second);
  if (solver.info() != Eigen::Success || !(solver.eigenvalues()(2) > 0)) return direction;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = solver.eigenvectors()(i, 2);
    direction[used[static_cast<std::size_t>(i) + 1]] += x;
    direction[used[0]] -= x;
  }
  return direction;
}

}  // namespace tensortopo::persistence
