// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distances/moved_vertices.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "run/parallel.hpp"

namespace certificate {
namespace {

constexpr auto kBothWays = {MovedVertices::kBehind, MovedVertices::kAhead};

}  // namespace

double reach_length(std::int64_t n) {
  const std::int64_t last = ((n % 4) + 4) % 4;
  const std::int64_t exponent = std::clamp<std::int64_t>((n - last) / 4, -2000, 2000);
  return std::ldexp(static_cast<double>(4 + last), static_cast<int>(exponent));
}

MovedVertices::MovedVertices(const LevelCase& c, const PlacedSurface& placed,
                             const std::vector<std::int64_t>& reach)
    : c_(c),
      placed_(placed),
      points_(2 * placed.carriers.size()),
      tensors_(c.field, 2 * placed.carriers.size()) {
  parallel_for(placed.carriers.size(), [&](std::size_t v) { move(v, reach_length(reach[v])); });
}

void MovedVertices::move(std::size_t vertex, double reach) {
  const Carrier& carrier = placed_.carriers[vertex];
  if (carrier.count < 2) return;  // a tip
  const auto size = static_cast<Eigen::Index>(carrier.count) - 1;
  const auto point = [&](std::size_t i) {
    return Eigen::Map<const Eigen::Vector3d>(c_.input.points[carrier.corners[i]].data());
  };
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> edges(3, size);
  for (Eigen::Index i = 0; i < size; ++i)
    edges.col(i) = point(static_cast<std::size_t>(i + 1)) - point(0);
  using Small = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
  const Eigen::LDLT<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>> solver(
      edges.transpose().lazyProduct(edges));
  // The nearest point of the carrier's plane, corrected once for rounding.
  const Eigen::Vector3d rest =
      Eigen::Map<const Eigen::Vector3d>(c_.surface.points[c_.vertices.first + vertex].data()) -
      point(0);
  Small weights = solver.solve(edges.transpose() * rest);
  weights += solver.solve(edges.transpose() * (rest - edges * weights));
  // The gradient of what the level is of, and its length.
  const long scale = scale_of(c_.field, carrier);
  std::array<Tensor<double>, 4> t;
  Tensor<double> m{};
  for (std::size_t i = 0; i < carrier.count; ++i) {
    const Vertex v = carrier.corners[i];
    const auto down = static_cast<int>(std::max(c_.field.scale(v) - scale, -2000L));
    const double w = i == 0 ? 1 - weights.sum() : weights(static_cast<Eigen::Index>(i) - 1);
    for (std::size_t k = 0; k < m.size(); ++k) {
      t[i][k] = std::ldexp((*c_.field.corner(v, false).ball)[k].value, down);
      m[k] += w * t[i][k];
    }
  }
  Small slope(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    Tensor<double> change;
    for (std::size_t k = 0; k < m.size(); ++k)
      change[k] = t[static_cast<std::size_t>(i) + 1][k] - t[0][k];
    slope(i) = c_.level.visit([&](const auto& rule) {
      return increase(rule.template forms<double, 2>({&m, &change}), {0, 1}).coefficients[0];
    });
  }
  const Small gradient = solver.solve(slope);
  const double by = reach / std::sqrt(slope.dot(gradient));
  for (const Way way : kBothWays) {
    const Small moved = weights + (way == kAhead ? by : -by) * gradient;
    auto& result = points_[id_of(vertex, way)];
    result[0] = 1 - moved.sum();
    for (Eigen::Index i = 0; i < size; ++i) result[static_cast<std::size_t>(i) + 1] = moved(i);
  }
  if (stays(vertex))
    for (const Way way : kBothWays)
      tensors_.set(id_of(vertex, way), carrier, points_[id_of(vertex, way)]);
}

bool MovedVertices::stays(std::size_t vertex) const {
  for (const Way way : kBothWays)
    for (std::size_t i = 0; i < placed_.carriers[vertex].count; ++i)
      if (!(weights(vertex, way)[i] > 0x1p-1000 && weights(vertex, way)[i] <= 1)) return false;
  return true;
}

bool MovedVertices::is_within(std::size_t vertex, double bound) const {
  const Carrier& carrier = placed_.carriers[vertex];
  const auto& x = c_.surface.points[c_.vertices.first + vertex];
  // | sum w_i (P_i - x) |^2 <= bound^2 (sum w_i)^2.
  const auto excess = [&]<class N>(Way way, const auto& number) {
    N total = number(0), square = number(0);
    for (std::size_t i = 0; i < carrier.count; ++i) total += number(weights(vertex, way)[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      N sum = number(0);
      for (std::size_t i = 0; i < carrier.count; ++i)
        sum += number(weights(vertex, way)[i]) *
               N(number(c_.input.points[carrier.corners[i]][k]) - number(x[k]));
      square += sum * sum;
    }
    const N limit = number(bound) * total;
    return N(square - N(limit * limit));
  };
  return std::all_of(kBothWays.begin(), kBothWays.end(), [&](Way way) {
    const Ball by_ball = excess.operator()<Ball>(way, [](double d) { return Ball(d, 0); });
    if (std::abs(by_ball.value) > by_ball.error) return by_ball.value < 0;
    return excess.operator()<mpq_class>(way, [](double d) { return mpq_class(d); }) <= 0;
  });
}

}  // namespace certificate
