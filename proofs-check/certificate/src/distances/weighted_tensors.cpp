// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distances/weighted_tensors.hpp"

#include <algorithm>
#include <cmath>

namespace certificate {
namespace {

/// The power of 2 of which x is an integer multiple of at most 53 bits.
long unit_of_double(double x) {
  int e = 0;
  std::frexp(x, &e);
  return e - 53;
}

}  // namespace

long scale_of(const Field& field, const Carrier& carrier) {
  long scale = field.scale(carrier.corners[0]);
  for (std::size_t i = 1; i < carrier.count; ++i)
    scale = std::max(scale, field.scale(carrier.corners[i]));
  return scale;
}

/// The power of 2 of which all weights times their tensors' are integer multiples.
long WeightedTensors::unit_of(const Point& point) const {
  long lowest = 0;
  for (std::size_t i = 0; i < point.carrier.count; ++i) {
    const long unit = unit_of_double(point.weights[i]) + field_.exponent(point.carrier.corners[i]);
    lowest = i == 0 ? unit : std::min(lowest, unit);
  }
  return lowest;
}

void WeightedTensors::set(std::uint32_t id, const Carrier& carrier,
                          const std::array<double, 4>& weights) {
  Point& point = points_[id];
  point = {carrier, weights, {}, 0};
  const long scale = scale_of(field_, carrier);
  for (std::size_t i = 0; i < carrier.count; ++i) {
    const Vertex v = carrier.corners[i];
    const long down = std::max(field_.scale(v) - scale, -2000L);
    const Ball weight(std::ldexp(weights[i], static_cast<int>(down)), down < -20 ? Ball::kTiny : 0);
    const Tensor<Ball>& t = *field_.corner(v, false).ball;
    for (std::size_t k = 0; k < t.size(); ++k) point.ball[k] += weight * t[k];
  }
  const int down = scale_to_one(point.ball);
  // exact() is in the unit, the ball in 2^(scale + down)
  point.shift = scale + down - unit_of(point);
}

std::uint32_t WeightedTensors::add(const Carrier& carrier, const std::array<double, 4>& weights) {
  points_.emplace_back();
  const auto id = static_cast<std::uint32_t>(points_.size() - 1);
  set(id, carrier, weights);
  return id;
}

Place<4> WeightedTensors::place(std::uint32_t id) const {
  const Point& point = points_[id];
  const long unit = unit_of(point);
  Place<4> result;
  for (std::size_t i = 0; i < point.carrier.count; ++i) {
    const long own = unit_of_double(point.weights[i]);
    result[i] = std::ldexp(point.weights[i], static_cast<int>(-own));
    result[i] <<=
        static_cast<unsigned long>(own + field_.exponent(point.carrier.corners[i]) - unit);
  }
  return result;
}

Tensor<mpz_class> WeightedTensors::exact(std::uint32_t id) const {
  const Point& point = points_[id];
  const Place<4> weights = place(id);
  Tensor<mpz_class> sum{};
  for (std::size_t i = 0; i < point.carrier.count; ++i) {
    const Tensor<mpz_class> t = field_.exact(point.carrier.corners[i]);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weights[i] * t[k];
  }
  return sum;
}

}  // namespace certificate
