// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "isotopy/apart.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "curves/conics.hpp"

namespace certificate {
namespace {

using Vector = Vector3<double>;

template <class N>
std::array<N, 3> minus(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

bool is_on_side(const Vector& direction, std::span<const BallPoint> vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [&](const BallPoint& v) {
    Ball product = 0;
    for (std::size_t k = 0; k < 3; ++k) product += Ball(direction[k], 0) * v[k];
    return product.value > product.error;
  });
}

/// Moves a direction past the unit vector with the least product, so far that this becomes `past`
/// of the direction's length, until all have as much (the relaxation method).
/// @return whether a direction on the way is one that all vectors are on the side of
bool is_side_found(Vector& d, std::span<const Vector> units, std::span<const BallPoint> vectors,
                   double past, int steps) {
  for (int step = 0; step < steps; ++step) {
    const Vector* worst = nullptr;
    double least = HUGE_VAL;
    for (const Vector& u : units)
      if (const double product = dot(d, u); product < least) least = product, worst = &u;
    if (worst == nullptr) return false;
    if (least > 0 && is_on_side(d, vectors)) return true;
    const double push = past * std::sqrt(dot(d, d)) - least;
    if (!(push > 0)) return false;
    for (std::size_t k = 0; k < 3; ++k) d[k] += push * (*worst)[k];
  }
  return false;
}

/// Of the vectors in a ball the one with the least product with the direction, at unit length.
Vector least_in(const BallPoint& v, const Vector& direction) {
  Vector u;
  for (std::size_t k = 0; k < 3; ++k) {
    const double error = direction[k] == 0 ? 0 : std::copysign(v[k].error, direction[k]);
    u[k] = v[k].value - error;
  }
  const double length = std::hypot(u[0], u[1], u[2]);
  for (double& x : u) x /= length;
  return u;
}

/// The direction with the largest least product with unit vectors, as far as rounding allows: on it
/// depend one of them, two, or three. Zero if the product is negative beyond rounding.
Vector best_side(std::span<const Vector> units) {
  // Where vectors nearly agree, the cross products of their differences are off by about as much.
  constexpr double kHopeless = -0x1p-12;
  Vector best{};
  double largest = kHopeless;
  const auto consider = [&](Vector d) {
    const double length = std::sqrt(dot(d, d));
    if (!(length > 0)) return;
    double least = HUGE_VAL;
    for (double& x : d) x /= length;
    for (const Vector& u : units) least = std::min(least, dot(d, u));
    if (least > largest) largest = least, best = d;
  };
  for (std::size_t i = 0; i < units.size(); ++i) {
    consider(units[i]);
    for (std::size_t j = 0; j < i; ++j) {
      consider(plus(units[i], units[j]));
      for (std::size_t k = 0; k < j; ++k) {
        const Vector normal =
            cross(minus(units[j], units[i]), minus(units[k], units[i]));
        consider(normal);
        consider({-normal[0], -normal[1], -normal[2]});
      }
    }
  }
  return best;
}

}  // namespace

/// By the middles of the balls first, then by those vectors in them as well for which the last
/// direction fails.
bool have_common_side(std::span<const BallPoint> vectors) {
  constexpr int kRounds = 6, kSteps = 8, kStepsOfRound = 24;
  constexpr double kFarPast = 0.1, kJustPast = 0x1p-44;
  std::vector<Vector> units;
  units.reserve(vectors.size());
  for (const BallPoint& v : vectors) units.push_back(least_in(v, {}));
  Vector d = std::accumulate(units.begin(), units.end(), Vector{}, plus);
  if (is_side_found(d, units, vectors, kFarPast, kSteps)) return true;
  for (int round = 0; round < kRounds; ++round) {
    d = best_side(units);
    if (d == Vector{}) return false;
    if (is_side_found(d, units, vectors, kJustPast, kStepsOfRound)) return true;
    const std::size_t known = units.size();
    for (const BallPoint& v : vectors)
      if (!is_on_side(d, {&v, 1})) units.push_back(least_in(v, d));
    if (units.size() == known) return true;
  }
  return false;
}

bool has_area(const BallPoint& a, const BallPoint& b, const BallPoint& c) {
  return have_common_side(std::array<BallPoint, 1>{cross(minus(b, a), minus(c, a))});
}

/// Closed convex sets that meet in a common vertex at most are parted by a plane (through it), so
/// what is looked for is its normal. Two triangles with a common edge meet in nothing else if they
/// are in different planes. In one plane they overlap if, seen along the edge, their other corners
/// are in one direction: if the products of the edge with both are positive multiples of each
/// other.
bool are_apart(std::span<const BallPoint> points, const std::array<std::uint32_t, 3>& first,
               const std::array<std::uint32_t, 3>& second) {
  auto a = first, b = second;
  std::size_t shared = 0;  // moved to the front
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = shared; j < 3; ++j)
      if (a[j] == second[i]) {
        std::swap(a[shared], a[j]);
        std::swap(b[shared], *std::find(b.begin(), b.end(), second[i]));
        ++shared;
        break;
      }
  const auto from = [&](std::uint32_t p, std::uint32_t q) { return minus(points[q], points[p]); };
  if (shared == 0) {
    std::array<BallPoint, 9> all;
    for (std::size_t i = 0; i < 9; ++i) all[i] = from(b[i % 3], a[i / 3]);
    return have_common_side(all);
  }
  if (shared == 1)
    return have_common_side(std::array{from(a[0], a[1]), from(a[0], a[2]), from(b[1], b[0]),
                                       from(b[2], b[0])});
  if (shared == 3) return false;
  const BallPoint edge = from(a[0], a[1]), normal = cross(edge, from(a[0], a[2])),
                  other = from(a[0], b[2]);
  Ball volume = 0;
  for (std::size_t k = 0; k < 3; ++k) volume += normal[k] * other[k];
  return std::abs(volume.value) > volume.error ||
         have_common_side(std::array{normal, cross(other, edge)});
}

}  // namespace certificate
