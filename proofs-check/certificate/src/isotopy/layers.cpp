// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "isotopy/layers.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "surface/box_tree.hpp"
#include "vertices/linear_field.hpp"

namespace certificate {
namespace {

/// Encloses a few numbers.
Ball hull(std::span<const Ball> balls) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Ball& b : balls) {
    low = std::min(low, b.value - b.error);
    high = std::max(high, b.value + b.error);
  }
  const double middle = low + (high - low) / 2;
  const double size = std::max(std::abs(low), std::abs(high));
  return {middle, ((high - low) / 2 + 4 * Ball::kUnit * size + Ball::kTiny) * Ball::kSlack};
}

BallPoint minus(const BallPoint& a, const BallPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Box box_of(std::span<const BallPoint> points, const std::array<std::uint32_t, 3>& triangle) {
  Box box;
  for (const std::uint32_t v : triangle) {
    Point3 low, high;
    for (std::size_t k = 0; k < 3; ++k) {  // outwards, however these are rounded
      const Ball& x = points[v][k];
      low[k] = x.value - 2 * x.error - std::abs(x.value) * Ball::kUnit;
      high[k] = x.value + 2 * x.error + std::abs(x.value) * Ball::kUnit;
    }
    box.add(low), box.add(high);
  }
  return box;
}

}  // namespace

/// Of places relative to the vertex: what is added to it at the end is rounded only once.
Layers::Span Layers::span_of(std::size_t vertex) const {
  const Carrier& carrier = placed_.carriers[vertex];
  const Point3& x = c_.surface.points[c_.vertices.first + vertex];
  std::array<BallPoint, 2> offset;
  for (const auto way : {MovedVertices::kBehind, MovedVertices::kAhead}) {
    const auto& weights = moved_.weights(vertex, way);
    Ball total = 0;
    for (std::size_t i = 0; i < carrier.count; ++i) total += Ball(weights[i], 0);
    for (std::size_t k = 0; k < 3; ++k) {
      Ball sum = 0;
      for (std::size_t i = 0; i < carrier.count; ++i)
        sum +=
            Ball(weights[i], 0) * (Ball(c_.input.points[carrier.corners[i]][k], 0) - Ball(x[k], 0));
      offset[way][k] = quotient(sum, total);
    }
  }
  Span span;
  span.step = minus(offset[MovedVertices::kAhead], offset[MovedVertices::kBehind]);
  for (std::size_t k = 0; k < 3; ++k)
    span.box[k] = Ball(x[k], 0) +
                  hull(std::array{offset[0][k], offset[1][k], Ball(0, places_[vertex][k].error)});
  return span;
}

bool Layers::are_embedded(std::span<const std::size_t> triangles) const {
  std::map<std::uint32_t, std::uint32_t> names;
  std::vector<BallPoint> points, steps;
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<Box> boxes;
  for (const std::size_t t : triangles) {
    auto& triangle = corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = c_.surface.triangles[c_.triangles.first + t][i];
      const auto [at, is_new] = names.emplace(v, static_cast<std::uint32_t>(points.size()));
      triangle[i] = at->second;
      if (!is_new) continue;
      const Span span = span_of(v - c_.vertices.first);
      points.push_back(span.box), steps.push_back(span.step);
    }
    boxes.push_back(box_of(points, triangle));
  }
  for (const auto& [a, b, c] : corners) {
    const BallPoint normal = cross(minus(points[b], points[a]), minus(points[c], points[a]));
    for (const std::uint32_t v : {a, b, c}) {
      const Ball ahead = dot(normal, steps[v]);
      if (!(ahead.value > ahead.error)) return false;
    }
  }
  const BoxTree tree(std::move(boxes));
  for (std::size_t s = 0; s < corners.size(); ++s) {
    bool apart = true;
    const bool all = tree.for_meeting(
        s, [&](std::size_t t) { apart = apart && are_apart(points, corners[s], corners[t]); });
    if (!apart || !all) return false;
  }
  return true;
}

}  // namespace certificate
