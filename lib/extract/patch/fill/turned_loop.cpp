// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/fill/turned_loop.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

namespace {

/// The difference of two angles in [-pi, pi].
double step(double from, double to) { return std::remainder(to - from, 2 * std::numbers::pi); }

}  // namespace

EigenvectorFrame frame_across(const Vector3<double>& dominant, const Vector3<double>& near) {
  const auto first = unit(near - dot(near, dominant) * dominant);
  return {first, cross(dominant, first)};
}

EigenvectorFrame frame_across(const Vector3<double>& dominant) {
  return frame_across(
      dominant, std::abs(dominant.x) < 0.6 ? Vector3<double>{1, 0, 0} : Vector3<double>{0, 1, 0});
}

std::optional<DirectedLoop> turned_loop(std::span<const BoundaryVertex> boundary,
                                        const EigenvectorFrame& frame) {
  std::vector<double> angles;
  for (const auto& v : boundary)
    angles.push_back(2 *
                     elementary::atan2(dot(v.medium, frame.second), dot(v.medium, frame.first)));
  const std::size_t n = boundary.size();
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) turned += step(angles[i], angles[(i + 1) % n]);
  if (std::abs(std::abs(turned) - 2 * std::numbers::pi) > 1) return std::nullopt;
  DirectedLoop result;
  result.is_clockwise = turned < 0;
  double angle = result.is_clockwise ? -angles[0] : angles[0];
  for (std::size_t i = 0; i < n; ++i) {
    result.loop.corners.push_back(boundary[i].id);
    result.loop.angles.push_back(angle);
    const double forward = step(angles[i], angles[(i + 1) % n]);
    if (result.is_clockwise ? !(forward < 0) : !(forward > 0)) return std::nullopt;
    angle += std::abs(forward);
  }
  return result;
}

void join_loops(const TurnedLoop& lower, const TurnedLoop& upper,
                std::vector<std::array<std::int32_t, 3>>& triangles) {
  const std::size_t n = lower.corners.size(), m = upper.corners.size();
  std::size_t start = 0;
  for (std::size_t j = 1; j < m; ++j)
    if (std::abs(step(lower.angles[0], upper.angles[j])) <
        std::abs(step(lower.angles[0], upper.angles[start])))
      start = j;
  const double offset = step(lower.angles[0], upper.angles[start]);
  const auto low = [&](std::size_t i) {
    return lower.angles[i % n] - lower.angles[0] + (i >= n ? 2 * std::numbers::pi : 0);
  };
  const auto high = [&](std::size_t j) {
    const std::size_t k = start + j;
    return offset + upper.angles[k % m] - upper.angles[start] +
           2 * std::numbers::pi * static_cast<double>(k / m);
  };
  std::size_t i = 0, j = 0;
  while (i < n || j < m) {
    const auto a = lower.corners[i % n], b = upper.corners[(start + j) % m];
    if (j == m || (i < n && low(i + 1) + low(i) < high(j + 1) + high(j))) {
      triangles.push_back({a, lower.corners[(i + 1) % n], b});
      ++i;
    } else {
      triangles.push_back({upper.corners[(start + j + 1) % m], b, a});
      ++j;
    }
  }
}

}  // namespace tensortopo
