// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "linking/hulls_apart.hpp"

#include <algorithm>
#include <limits>

#include "tensortopo/scalar/floating_point_environment.hpp"
#include "tensortopo/scalar/interval.hpp"

namespace tensortopo {
namespace {

/// Steps towards the points of the hulls that are nearest to each other.
constexpr int kSteps = 40;

Interval height(const PlaceBox& box, const Vector3<double>& up) {
  return Interval(up.x) * Interval(box.low.x, box.high.x) +
         Interval(up.y) * Interval(box.low.y, box.high.y) +
         Interval(up.z) * Interval(box.low.z, box.high.z);
}

bool are_above(std::span<const PlaceBox> a, std::span<const PlaceBox> b,
               const Vector3<double>& up) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const PlaceBox& box : a) lowest = std::min(lowest, height(box, up).inf());
  for (const PlaceBox& box : b) highest = std::max(highest, height(box, up).sup());
  return lowest > highest;
}

Vector3<double> extreme(std::span<const PlaceBox> boxes, const Vector3<double>& direction) {
  Vector3<double> best = boxes[0].middle();
  for (const PlaceBox& box : boxes)
    if (dot(box.middle(), direction) > dot(best, direction)) best = box.middle();
  return best;
}

}  // namespace

bool are_hulls_apart(std::span<const PlaceBox> a, std::span<const PlaceBox> b) {
  const FloatingPointEnvironment environment;
  // The method of Frank and Wolfe for the shortest vector from one hull to the other, rounded; what
  // it finds is proved.
  Vector3<double> shortest = a[0].middle() - b[0].middle();
  for (int step = 0; step < kSteps; ++step) {
    if (are_above(a, b, shortest)) return true;
    const auto next = extreme(a, -shortest) - extreme(b, shortest), move = next - shortest;
    const double square = dot(move, move);
    if (!(square > 0)) return false;
    shortest += std::clamp(-dot(shortest, move) / square, 0.0, 1.0) * move;
  }
  return false;
}

}  // namespace tensortopo
