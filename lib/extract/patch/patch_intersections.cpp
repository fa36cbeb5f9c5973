// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/patch_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace tensortopo {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A triangle and the box around it.
struct Side {
  std::array<Kernel::Point_3, 3> corners;
  std::array<double, 3> low, high;
};

bool has_area(const Side& s) { return !CGAL::collinear(s.corners[0], s.corners[1], s.corners[2]); }

Side side_of(std::span<const Vector3<double>> points, const PatchTriangle& t) {
  Side side{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& p = points[t[i]];
    side.corners[i] = Kernel::Point_3(p.x, p.y, p.z);
    const std::array<double, 3> x{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      side.low[k] = i == 0 ? x[k] : std::min(side.low[k], x[k]);
      side.high[k] = i == 0 ? x[k] : std::max(side.high[k], x[k]);
    }
  }
  return side;
}

bool boxes_meet(const Side& s, const Side& t) {
  for (std::size_t k = 0; k < 3; ++k)
    if (s.high[k] < t.low[k] || t.high[k] < s.low[k]) return false;
  return true;
}

/// What two triangles have in common is convex: if it is more than a common corner it goes on from
/// there to the opposite side of one of the two.
bool intersect(const Side& first, const Side& second) {
  if (!boxes_meet(first, second) || !has_area(first) || !has_area(second)) return false;
  auto s = first.corners, t = second.corners;
  std::size_t shared = 0;  // moved to the front
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = shared; j < 3; ++j)
      if (s[j] == t[i]) {
        std::swap(s[shared], s[j]), std::swap(t[shared], t[i]);
        ++shared;
        break;
      }
  if (shared == 3) return true;
  if (shared == 2)
    return CGAL::coplanar(s[0], s[1], s[2], t[2]) &&
           CGAL::coplanar_orientation(s[0], s[1], s[2], t[2]) == CGAL::POSITIVE;
  const Kernel::Triangle_3 a(s[0], s[1], s[2]), b(t[0], t[1], t[2]);
  if (shared == 0) return CGAL::do_intersect(a, b);
  return CGAL::do_intersect(a, Kernel::Segment_3(t[1], t[2])) ||
         CGAL::do_intersect(b, Kernel::Segment_3(s[1], s[2]));
}

std::vector<Side> sides_of(std::span<const Vector3<double>> points,
                           std::span<const PatchTriangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(triangles.size());
  for (const auto& t : triangles) sides.push_back(side_of(points, t));
  return sides;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> intersecting_pairs(
    std::span<const Vector3<double>> points, std::span<const PatchTriangle> triangles) {
  const auto sides = sides_of(points, triangles);
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < sides.size(); ++i)
    order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(sides[i].low[0], i) < std::pair(sides[j].low[0], j);
  });
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const auto &s = sides[order[i]], &t = sides[order[j]];
      if (t.low[0] > s.high[0]) break;
      if (!intersect(s, t)) continue;
      const auto [a, b] = std::minmax(order[i], order[j]);
      pairs.push_back({a, b});
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool intersects_any(std::span<const Vector3<double>> points, std::span<const PatchTriangle> first,
                    std::span<const PatchTriangle> others) {
  const auto sides = sides_of(points, first);
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j)
      if (intersect(sides[i], sides[j])) return true;
  for (const auto& t : others) {
    const Side side = side_of(points, t);
    for (const auto& s : sides)
      if (intersect(s, side)) return true;
  }
  return false;
}

}  // namespace tensortopo
