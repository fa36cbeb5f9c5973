// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/moved_vertices.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "run/parallel.hpp"

namespace certificate {
namespace {

constexpr auto kBothWays = {MovedVertices::kBehind, MovedVertices::kAhead};

/// The power of 2 of which x is an integer multiple of at most 53 bits.
long unit_of(double x) {
  int e = 0;
  std::frexp(x, &e);
  return e - 53;
}

}  // namespace

double reach_length(std::int64_t n) {
  const std::int64_t last = ((n % 4) + 4) % 4;
  const std::int64_t exponent = std::clamp<std::int64_t>((n - last) / 4, -2000, 2000);
  return std::ldexp(static_cast<double>(4 + last), static_cast<int>(exponent));
}

MovedVertices::MovedVertices(const LevelCase& c, const PlacedSurface& placed,
                             const std::vector<std::int64_t>& reach)
    : c_(c), placed_(placed), points_(2 * placed.carriers.size()) {
  parallel_for(placed.carriers.size(), [&](std::size_t v) { move(v, reach_length(reach[v])); });
}

/// The largest scale of the corners' balls.
long MovedVertices::scale_of(const Carrier& carrier) const {
  long scale = c_.field.scale(carrier.corners[0]);
  for (std::size_t i = 1; i < carrier.count; ++i)
    scale = std::max(scale, c_.field.scale(carrier.corners[i]));
  return scale;
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
  const long scale = scale_of(carrier);
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
    auto& result = points_[2 * vertex + way].weights;
    result[0] = 1 - moved.sum();
    for (Eigen::Index i = 0; i < size; ++i) result[static_cast<std::size_t>(i) + 1] = moved(i);
  }
  if (stays(vertex))
    for (const Way way : kBothWays) enclose(carrier, points_[2 * vertex + way]);
}

bool MovedVertices::stays(std::size_t vertex) const {
  for (const Way way : kBothWays)
    for (std::size_t i = 0; i < placed_.carriers[vertex].count; ++i)
      if (!(weights(vertex, way)[i] > 0x1p-1000 && weights(vertex, way)[i] <= 1)) return false;
  return true;
}

/// The power of 2 of which all weights times their tensors' are integer multiples.
long MovedVertices::unit_of(const Carrier& carrier, const Point& point) const {
  long lowest = 0;
  for (std::size_t i = 0; i < carrier.count; ++i) {
    const long unit =
        certificate::unit_of(point.weights[i]) + c_.field.exponent(carrier.corners[i]);
    lowest = i == 0 ? unit : std::min(lowest, unit);
  }
  return lowest;
}

void MovedVertices::enclose(const Carrier& carrier, Point& point) const {
  const long scale = scale_of(carrier);
  for (std::size_t i = 0; i < carrier.count; ++i) {
    const Vertex v = carrier.corners[i];
    const long down = std::max(c_.field.scale(v) - scale, -2000L);
    const Ball weight(std::ldexp(point.weights[i], static_cast<int>(down)),
                      down < -20 ? Ball::kTiny : 0);
    const Tensor<Ball>& t = *c_.field.corner(v, false).ball;
    for (std::size_t k = 0; k < t.size(); ++k) point.ball[k] += weight * t[k];
  }
  const int down = scale_to_one(point.ball);
  // exact() is in the unit, the ball in 2^(scale + down)
  point.shift = scale + down - unit_of(carrier, point);
}

Place<4> MovedVertices::place(std::size_t vertex, Way way) const {
  const Carrier& carrier = placed_.carriers[vertex];
  const Point& point = points_[2 * vertex + way];
  const long unit = unit_of(carrier, point);
  Place<4> result;
  for (std::size_t i = 0; i < carrier.count; ++i) {
    const long own = certificate::unit_of(point.weights[i]);
    result[i] = std::ldexp(point.weights[i], static_cast<int>(-own));
    result[i] <<= static_cast<unsigned long>(own + c_.field.exponent(carrier.corners[i]) - unit);
  }
  return result;
}

Tensor<mpz_class> MovedVertices::exact(std::uint32_t id) const {
  const Place<4> weights = place(id / 2, static_cast<Way>(id % 2));
  Tensor<mpz_class> sum{};
  for (std::size_t i = 0; i < placed_.carriers[id / 2].count; ++i) {
    const Tensor<mpz_class> t = c_.field.exact(placed_.carriers[id / 2].corners[i]);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weights[i] * t[k];
  }
  return sum;
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
