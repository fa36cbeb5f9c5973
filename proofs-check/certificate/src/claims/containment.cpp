// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/containment.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ball.hpp"
#include "mesh/exact_vectors.hpp"

namespace certificate {
namespace {

double slack_on(std::span<const Point3> corners, std::size_t axis) {
  double largest = 0;
  for (const Point3& p : corners) largest = std::max(largest, std::abs(p[axis]));
  return rounding_of(largest);
}

/// Do a box around x and the hull of the corners have a common point? Two convex polytopes have
/// none exactly if the normal of a face of one, or of an edge of each, separates them.
bool meets_box(const ExactVector& x, const ExactVector& slack, const std::vector<ExactVector>& corners) {
  std::vector<ExactVector> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) edges.push_back(minus(corners[i], corners[j]));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) axes.push_back(cross(edges[i], axes[k]));
    for (std::size_t j = 0; j < i; ++j) axes.push_back(cross(edges[i], edges[j]));
  }
  return std::all_of(axes.begin(), axes.end(), [&](const ExactVector& d) {
    mpq_class least = dot(d, corners[0]), most = least;
    for (const ExactVector& p : corners) {
      const mpq_class at = dot(d, p);
      if (at < least) least = at;
      if (at > most) most = at;
    }
    const mpq_class reach = abs(d[0]) * slack[0] + abs(d[1]) * slack[1] + abs(d[2]) * slack[2];
    const mpq_class middle = dot(d, x);
    return least <= middle + reach && most >= middle - reach;
  });
}

/// Is the sum of w_i P_i, divided by that of the weights, as near to x on each axis? Yes or unsure.
bool is_near(const Point3& x, std::span<const Point3> corners, const std::array<double, 4>& weights) {
  Ball total = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) total += Ball(weights[i], 0);
  for (std::size_t k = 0; k < 3; ++k) {
    Ball sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
      sum += Ball(weights[i], 0) * (Ball(corners[i][k], 0) - Ball(x[k], 0));
    const Ball limit = Ball(slack_on(corners, k), 0) * total;
    if (!(std::abs(sum.value) + sum.error <= limit.value - limit.error)) return false;
  }
  return true;
}

}  // namespace

std::array<double, 4> weights_near(const Point3& x, std::span<const Point3> corners) {
  const auto vector = [](const Point3& p) { return Eigen::Map<const Eigen::Vector3d>(p.data()); };
  Eigen::Vector3d rest = vector(x) - vector(corners[0]);
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  for (std::size_t i = 1; i < corners.size(); ++i)
    axes.col(static_cast<Eigen::Index>(i) - 1) = vector(corners[i]) - vector(corners[0]);
  // In units of about the largest edge, so that it does not matter in which ones coordinates are.
  const double size = axes.cwiseAbs().maxCoeff();
  const double unit = size > 0 ? std::ldexp(1.0, std::min(-std::ilogb(size), 1000)) : 1;
  axes *= unit, rest *= unit;
  // Normals for the axes that an edge or a face lacks.
  if (corners.size() == 2) axes.col(1) = axes.col(0).unitOrthogonal();
  if (corners.size() <= 3) axes.col(2) = axes.col(0).cross(axes.col(1)).stableNormalized();
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(axes);
  Eigen::Vector3d w = solver.solve(rest);
  w += solver.solve(rest - axes * w);
  std::array<double, 4> result{1};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    result[i] = std::max(0.0, w(static_cast<Eigen::Index>(i) - 1));
    result[0] -= w(static_cast<Eigen::Index>(i) - 1);
  }
  result[0] = std::max(0.0, result[0]);
  return result;
}

bool lies_in(const Point3& x, std::span<const Point3> corners) {
  if (corners.size() > 1) {
    const auto weights = weights_near(x, corners);
    const bool are_weights = std::all_of(weights.begin(), weights.end(),
                                         [](double w) { return w >= 0 && w <= 2; });
    if (are_weights && is_near(x, corners, weights)) return true;
  }
  std::vector<ExactVector> all;
  for (const Point3& p : corners) all.push_back(exact(p));
  return meets_box(exact(x), {slack_on(corners, 0), slack_on(corners, 1), slack_on(corners, 2)},
                   all);
}

bool lies_between(const Point3& x, const Point3& a, const Point3& b, const mpq_class& from,
                  const mpq_class& to) {
  const std::array corners{a, b};
  const auto weights = weights_near(x, corners);
  const double t = weights[1] / (weights[0] + weights[1]);
  if (t >= 0 && t <= 1 && from <= t && t <= to && is_near(x, corners, {1 - t, t})) return true;
  ExactVector first = exact(a), last = first, along = minus(exact(b), first);
  for (std::size_t k = 0; k < 3; ++k) first[k] += from * along[k], last[k] += to * along[k];
  return meets_box(exact(x), {slack_on(corners, 0), slack_on(corners, 1), slack_on(corners, 2)},
                   {first, last});
}

}  // namespace certificate
