// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "moved_vertices.hpp"

#include <algorithm>
#include <cmath>

#include "parallel.hpp"

namespace certificate {
namespace {

using Place = std::array<double, 3>;

double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Solves a x = y of up to three rows by elimination, largest pivots first.
Place solve(std::array<Place, 3> a, Place y, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    std::size_t best = i;
    for (std::size_t r = i; r < size; ++r)
      if (std::abs(a[r][i]) > std::abs(a[best][i])) best = r;
    std::swap(a[i], a[best]), std::swap(y[i], y[best]);
    for (std::size_t r = 0; r < size; ++r) {
      if (r == i) continue;
      const double factor = a[r][i] / a[i][i];
      for (std::size_t k = i; k < size; ++k) a[r][k] -= factor * a[i][k];
      y[r] -= factor * y[i];
    }
  }
  Place x{};
  for (std::size_t i = 0; i < size; ++i) x[i] = y[i] / a[i][i];
  return x;
}

/// An integer, and in `exponent` the power of 2 that makes it x.
mpz_class integer_of(double x, long& exponent) {
  int e = 0;
  const mpz_class mantissa(std::ldexp(std::frexp(x, &e), 53));
  exponent = e - 53;
  return mantissa;
}

}  // namespace

double reach_length(std::int64_t n) {
  const std::int64_t last = ((n % 4) + 4) % 4;
  const std::int64_t exponent = std::clamp<std::int64_t>((n - last) / 4, -2000, 2000);
  return std::ldexp(static_cast<double>(4 + last), static_cast<int>(exponent));
}

MovedVertices::MovedVertices(const LevelCase& c, const PlacedSurface& placed)
    : c_(c), placed_(placed), points_(2 * placed.carriers.size()) {
  parallel_for(placed.carriers.size(), [&](std::size_t v) { move(v); });
}

void MovedVertices::move(std::size_t vertex) {
  const Carrier& carrier = placed_.carriers[vertex];
  const std::size_t size = carrier.count - 1;
  const Place& x = c_.surface.points[c_.claims.vertices[0] + vertex];
  const Place& origin = c_.input.points[carrier.corners[0]];
  std::array<Place, 3> edges{}, gram{};
  Place rest{};
  for (std::size_t k = 0; k < 3; ++k) {
    rest[k] = x[k] - origin[k];
    for (std::size_t i = 0; i < size; ++i)
      edges[i][k] = c_.input.points[carrier.corners[i + 1]][k] - origin[k];
  }
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) gram[i][j] = dot(edges[i], edges[j]);
  // The nearest point of the carrier's plane, corrected once for rounding.
  Place weights{};
  for (int step = 0; step < 2; ++step) {
    Place right{};
    for (std::size_t i = 0; i < size; ++i) right[i] = dot(edges[i], rest);
    const Place more = solve(gram, right, size);
    for (std::size_t i = 0; i < size; ++i) {
      weights[i] += more[i];
      for (std::size_t k = 0; k < 3; ++k) rest[k] -= more[i] * edges[i][k];
    }
  }
  // The gradient of the mode, and its length.
  std::array<Tensor<double>, 4> t;
  long scale = c_.field.scale(carrier.corners[0]);
  for (std::size_t i = 1; i <= size; ++i)
    scale = std::max(scale, c_.field.scale(carrier.corners[i]));
  Tensor<double> m{};
  double first = 1;
  for (std::size_t i = 0; i < size; ++i) first -= weights[i];
  for (std::size_t i = 0; i <= size; ++i) {
    const Vertex v = carrier.corners[i];
    for (std::size_t k = 0; k < 6; ++k) {
      const long down = std::max(c_.field.scale(v) - scale, -2000L);
      t[i][k] = std::ldexp((*c_.field.corner(v, false).ball)[k].value, static_cast<int>(down));
      m[k] += (i == 0 ? first : weights[i - 1]) * t[i][k];
    }
  }
  const Tensor<double> cofactor = cofactors(m);
  const double p = trace(m, m), q = (m[0] * cofactor[0] + m[5] * cofactor[5] + m[4] * cofactor[4]);
  Place slope{};
  for (std::size_t i = 0; i < size; ++i) {
    Tensor<double> change;
    for (std::size_t k = 0; k < 6; ++k) change[k] = t[i + 1][k] - t[0][k];
    slope[i] = 2 * p * trace(cofactor, change) - 6 * q * trace(m, change);
  }
  const Place gradient = solve(gram, slope, size);
  const double length = std::sqrt(dot(slope, gradient));
  const double reach = reach_length(c_.claims.distance->reach[vertex]);
  for (const Way way : {kBehind, kAhead}) {
    Point& point = points_[2 * vertex + way];
    const double by = (way == kAhead ? reach : -reach) / length;
    point.weights[0] = 1;
    for (std::size_t i = 0; i < size; ++i) {
      point.weights[i + 1] = weights[i] + by * gradient[i];
      point.weights[0] -= point.weights[i + 1];
    }
  }
  if (stays(vertex))
    for (const Way way : {kBehind, kAhead}) enclose(carrier, points_[2 * vertex + way]);
}

bool MovedVertices::stays(std::size_t vertex) const {
  for (const Way way : {kBehind, kAhead})
    for (std::size_t i = 0; i < placed_.carriers[vertex].count; ++i)
      if (!(weights(vertex, way)[i] > 0x1p-1000 && weights(vertex, way)[i] <= 1)) return false;
  return true;
}

void MovedVertices::enclose(const Carrier& carrier, Point& point) const {
  long scale = c_.field.scale(carrier.corners[0]);
  for (std::size_t i = 1; i < carrier.count; ++i)
    scale = std::max(scale, c_.field.scale(carrier.corners[i]));
  long lowest = 0;
  for (std::size_t i = 0; i < carrier.count; ++i) {
    const Vertex v = carrier.corners[i];
    const long down = std::max(c_.field.scale(v) - scale, -2000L);
    const Ball weight(std::ldexp(point.weights[i], static_cast<int>(down)),
                      down < -20 ? Ball::kTiny : 0);
    const Tensor<Ball>& t = *c_.field.corner(v, false).ball;
    for (std::size_t k = 0; k < 6; ++k) point.ball[k] += weight * t[k];
    long exponent = 0;
    integer_of(point.weights[i], exponent);
    exponent += c_.field.exponent(v);
    lowest = i == 0 ? exponent : std::min(lowest, exponent);
  }
  // exact() is in units of 2^lowest, the ball of 2^scale.
  point.shift = scale - lowest;
}

Tensor<mpz_class> MovedVertices::exact(std::uint32_t id) const {
  const Carrier& carrier = placed_.carriers[id / 2];
  std::array<mpz_class, 4> weights;
  std::array<long, 4> exponents{};
  for (std::size_t i = 0; i < carrier.count; ++i) {
    weights[i] = integer_of(points_[id].weights[i], exponents[i]);
    exponents[i] += c_.field.exponent(carrier.corners[i]);
  }
  const long lowest = *std::min_element(exponents.begin(), exponents.begin() +
                                        static_cast<std::ptrdiff_t>(carrier.count));
  Tensor<mpz_class> sum{};
  for (std::size_t i = 0; i < carrier.count; ++i) {
    weights[i] <<= static_cast<unsigned long>(exponents[i] - lowest);
    const Tensor<mpz_class> t = c_.field.exact(carrier.corners[i]);
    for (std::size_t k = 0; k < 6; ++k) sum[k] += weights[i] * t[k];
  }
  return sum;
}

bool MovedVertices::is_within(std::size_t vertex, double bound) const {
  const Carrier& carrier = placed_.carriers[vertex];
  const Place& x = c_.surface.points[c_.claims.vertices[0] + vertex];
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
  for (const Way way : {kBehind, kAhead}) {
    const Ball by_ball = excess.operator()<Ball>(way, [](double d) { return Ball(d, 0); });
    if (-by_ball.value > by_ball.error) continue;
    if (by_ball.value > by_ball.error) return false;
    if (excess.operator()<mpq_class>(way, [](double d) { return mpq_class(d); }) > 0) return false;
  }
  return true;
}

}  // namespace certificate
