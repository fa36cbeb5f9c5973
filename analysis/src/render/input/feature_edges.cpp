// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/input/feature_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>

namespace tensortopo {
namespace {

using Index = SurfaceMesh::Index;

/// A side of a triangle, its smaller vertex first.
struct Side {
  Index low, high, triangle;
  std::size_t first;  ///< the corner that it begins at in the triangle
};

/// Unit; 0 of a flat triangle.
Vector3<double> normal_of(const SurfaceMesh& surface, Index triangle) {
  const auto& t = surface.triangles[as_size(triangle)];
  const auto& p = surface.points;
  return unit_or_zero(
      cross(p[as_size(t[1])] - p[as_size(t[0])], p[as_size(t[2])] - p[as_size(t[0])]));
}

std::vector<Side> sides_of(const SurfaceMesh& surface) {
  std::vector<Side> sides;
  sides.reserve(3 * surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& t = surface.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      sides.push_back({low, high, static_cast<Index>(i), k});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return std::tie(s.low, s.high, s.triangle) < std::tie(t.low, t.high, t.triangle);
  });
  return sides;
}

}  // namespace

std::vector<std::array<Index, 2>> feature_edges(const SurfaceMesh& surface, EdgeKind kind) {
  const std::vector<Side> sides = sides_of(surface);
  const double bent = std::cos(kFeatureAngle * std::numbers::pi / 180);
  const auto is_wanted = [&](std::size_t first, std::size_t count) {
    if (kind == EdgeKind::boundary) return count == 1;
    return count == 2 && dot(normal_of(surface, sides[first].triangle),
                             normal_of(surface, sides[first + 1].triangle)) <= bent;
  };
  std::vector<std::array<std::size_t, 2>> places;
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    const Side& side = sides[i];
    while (next < sides.size() && sides[next].low == side.low && sides[next].high == side.high)
      ++next;
    if (is_wanted(i, next - i)) places.push_back({as_size(side.triangle), side.first});
  }
  std::sort(places.begin(), places.end());
  std::vector<std::array<Index, 2>> edges;
  for (const auto& [triangle, k] : places) {
    const auto& t = surface.triangles[triangle];
    edges.push_back({t[k], t[(k + 1) % 3]});
  }
  return edges;
}

}  // namespace tensortopo
