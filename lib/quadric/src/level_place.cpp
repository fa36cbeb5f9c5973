// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "level_place.hpp"

#include <algorithm>
#include <cmath>

#include "cell_scale.hpp"

namespace tensortopo {
namespace {

constexpr double kClearance = 0x1p-40;
/// Of a corner, in a place in the interior of a simplex.
constexpr double kLeastShare = 0x1p-20;

Weights mix(const Weights& u, const Weights& v, double t) {
  Weights result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = (1 - t) * u[i] + t * v[i];
  return result;
}

Weights difference(const Weights& u, const Weights& v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2], u[3] - v[3]};
}

/// Solves h y = -g by Cramer's rule; the result is not finite where h is singular.
template <std::size_t Order>
void solve(const std::array<std::array<double, 3>, 3>& h, const std::array<double, 3>& g,
           std::array<double, 3>& y) {
  SquareMatrix<double, Order> a;
  for (std::size_t i = 0; i < Order; ++i)
    for (std::size_t j = 0; j < Order; ++j) a[i][j] = h[i][j];
  const double determinant = determinant_of<double, Order>(a);
  for (std::size_t k = 0; k < Order; ++k) {
    auto b = a;
    for (std::size_t i = 0; i < Order; ++i) b[i][k] = -g[i];
    y[k] = determinant_of<double, Order>(b) / determinant;
  }
}

}  // namespace

CellGeometry::CellGeometry(const ConvexLevel& level,
                           const std::array<const SymmetricTensor<double>*, 4>& tensors,
                           const std::array<Vector3<double>, 4>& points, bool is_positive)
    : points_(points) {
  const CellScale scale(tensors);
  const double value = std::ldexp(level.value, scale.exponent);
  tau_ = level.tau.convert_to<double>();
  gamma_ = level.gamma == 0 ? 0 : 3 * value * value;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto t = scale(*tensors[i]);
    deviators_[i] = deviator(t);
    traces_[i] = trace(t);
  }
  std::array<Vector3<double>, 3> edges;
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    edges[i] = points[i + 1] - points[0];
    size = std::max({size, std::abs(edges[i].x), std::abs(edges[i].y), std::abs(edges[i].z)});
  }
  const double unit = std::ldexp(1.0, -std::ilogb(size));
  for (auto& edge : edges) edge = unit * edge;
  for (std::size_t i = 0; i < 3; ++i)
    inward_[i] = (is_positive ? 1.0 : -1.0) * cross(edges[(i + 1) % 3], edges[(i + 2) % 3]);
}

CellGeometry::Parts CellGeometry::tensor_at(const Weights& w) const {
  Parts result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.deviator = result.deviator + w[i] * deviators_[i];
    result.trace += w[i] * traces_[i];
  }
  return result;
}

double CellGeometry::form(const Weights& u, const Weights& v) const {
  const Parts s = tensor_at(u), t = tensor_at(v);
  double u_sum = 0, v_sum = 0;
  for (std::size_t i = 0; i < 4; ++i) u_sum += u[i], v_sum += v[i];
  return norm_form(s.deviator, t.deviator) + tau_ * s.trace * t.trace - gamma_ * u_sum * v_sum;
}

Weights CellGeometry::inner_place(std::span<const Weights> corners) const {
  const std::size_t order = corners.size() - 1;
  std::array<Weights, 3> along;
  std::array<std::array<double, 3>, 3> h{};
  std::array<double, 3> g{}, y{};
  for (std::size_t i = 0; i < order; ++i) along[i] = difference(corners[i + 1], corners[0]);
  for (std::size_t i = 0; i < order; ++i) {
    g[i] = form(corners[0], along[i]);
    for (std::size_t j = 0; j < order; ++j) h[i][j] = form(along[i], along[j]);
  }
  if (order == 1) solve<1>(h, g, y);
  if (order == 2) solve<2>(h, g, y);
  if (order == 3) solve<3>(h, g, y);
  std::array<double, 4> share{1, 0, 0, 0};
  for (std::size_t i = 0; i < order; ++i) share[i + 1] = y[i], share[0] -= y[i];
  double sum = 0;
  for (std::size_t i = 0; i <= order; ++i) {
    if (!std::isfinite(share[i])) share[i] = 1;
    sum += share[i] = std::clamp(share[i], kLeastShare, 1.0);
  }
  Weights result{};
  for (std::size_t i = 0; i <= order; ++i)
    for (std::size_t k = 0; k < 4; ++k) result[k] += share[i] / sum * corners[i][k];
  return result;
}

Weights CellGeometry::crossing(const Weights& inside, const Weights& outside) const {
  const Weights along = difference(outside, inside);
  const double a = form(along, along), b = form(inside, along);
  const double c = std::min(0.0, form(inside, inside));
  // The smallest root >= 0 of c + 2 b t + a t^2: between the nappes there are two, and this is the
  // one next to the inside place.
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  double t = b > 0 ? -c / (b + root) : (root - b) / a;
  if (!(t > kClearance)) t = kClearance;
  return mix(inside, outside, std::min(t, 1 - kClearance));
}

Vector3<double> CellGeometry::position(const Weights& w) const {
  Vector3<double> result{};
  for (std::size_t i = 0; i < 4; ++i) result += w[i] * points_[i];
  return result;
}

Vector3<double> CellGeometry::normal(const Weights& w) const {
  const Parts at = tensor_at(w);
  // Of the anisotropy the form has the gradient on its level only: elsewhere, and so at vertices
  // that are kept clear of corners, that of the level through the place.
  const double tau = tau_ < 0 ? -norm_form(at.deviator, at.deviator) / (at.trace * at.trace) : tau_;
  Vector3<double> sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    Weights along{-1, 0, 0, 0};
    along[i + 1] = 1;
    const Parts change = tensor_at(along);
    sum += (norm_form(at.deviator, change.deviator) + tau * at.trace * change.trace) * inward_[i];
  }
  return std::isfinite(length(sum)) ? unit_or_zero(sum) : Vector3<double>{};
}

}  // namespace tensortopo
