// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/patch_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace tensortopo {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

double largest(const Vector3<double>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// A triangle, the box around it and its plane.
struct Side {
  PatchTriangle places;
  std::array<Vector3<double>, 3> corners;
  std::array<double, 3> low, high;
  Vector3<double> normal;
  double
      error;  ///< of a product with the normal, for a vector of length 1 in the largest coordinate
  bool has_area;
};

/// Six products of three differences: each of these has one rounding, a product two, sums five at
/// most, which is less than 64 roundings of the product of the largest coordinates. Products below
/// the smallest doubles lose less than the last term.
constexpr double kRoundings = 64 * 0x1p-53, kUnderflow = 0x1p-1000;

Kernel::Point_3 point(const Vector3<double>& p) { return {p.x, p.y, p.z}; }

bool are_collinear(const std::array<Vector3<double>, 3>& c) {
  return CGAL::collinear(point(c[0]), point(c[1]), point(c[2]));
}

Side side_of(std::span<const Vector3<double>> points, const PatchTriangle& t) {
  Side side{};
  side.places = t;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& p = points[t[i]];
    side.corners[i] = p;
    const std::array<double, 3> x{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      side.low[k] = i == 0 ? x[k] : std::min(side.low[k], x[k]);
      side.high[k] = i == 0 ? x[k] : std::max(side.high[k], x[k]);
    }
  }
  const auto u = side.corners[1] - side.corners[0], v = side.corners[2] - side.corners[0];
  side.normal = cross(u, v);
  side.error = kRoundings * largest(u) * largest(v);
  side.has_area = largest(side.normal) > side.error + kUnderflow || !are_collinear(side.corners);
  return side;
}

bool boxes_meet(const Side& s, const Side& t) {
  for (std::size_t k = 0; k < 3; ++k)
    if (s.high[k] < t.low[k] || t.high[k] < s.low[k]) return false;
  return true;
}

/// Whether doubles show that a point is on one side of the plane of a triangle: 1 or -1, else 0.
int side_in_doubles(const Side& plane, const Vector3<double>& p) {
  const auto d = p - plane.corners[0];
  const double value = dot(plane.normal, d);
  const double error = plane.error * largest(d) + kUnderflow;
  return value > error ? 1 : value < -error ? -1 : 0;
}

/// Whether the corners from the first on are shown to be on one side of a plane.
bool is_apart(const Side& plane, const std::array<Vector3<double>, 3>& corners, std::size_t first) {
  const int side = side_in_doubles(plane, corners[first]);
  if (side == 0) return false;
  for (std::size_t i = first + 1; i < 3; ++i)
    if (side_in_doubles(plane, corners[i]) != side) return false;
  return true;
}

/// Corners that are the same vertex.
enum class Same { place, number };

/// What two triangles with an area have in common is convex: if it is more than a common corner it
/// goes on from there to the opposite side of one of the two.
template <Same same>
bool intersect(const Side& first, const Side& second) {
  std::array<std::size_t, 3> i{0, 1, 2}, j{0, 1, 2};
  std::size_t shared = 0;  // moved to the front
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t l = shared; l < 3; ++l) {
      const bool are_same = same == Same::number
                                ? first.places[i[l]] == second.places[j[k]]
                                : first.corners[i[l]] == second.corners[j[k]];
      if (!are_same) continue;
      std::swap(i[shared], i[l]), std::swap(j[shared], j[k]);
      ++shared;
      break;
    }
  if (shared == 3) return true;
  const std::array s{first.corners[i[0]], first.corners[i[1]], first.corners[i[2]]},
      t{second.corners[j[0]], second.corners[j[1]], second.corners[j[2]]};
  if (is_apart(first, t, shared) || is_apart(second, s, shared)) return false;
  const std::array a{point(s[0]), point(s[1]), point(s[2])},
      b{point(t[0]), point(t[1]), point(t[2])};
  if (shared == 2)
    return CGAL::coplanar(a[0], a[1], a[2], b[2]) &&
           CGAL::coplanar_orientation(a[0], a[1], a[2], b[2]) == CGAL::POSITIVE;
  const Kernel::Triangle_3 one(a[0], a[1], a[2]), other(b[0], b[1], b[2]);
  if (shared == 0) return CGAL::do_intersect(one, other);
  return CGAL::do_intersect(one, Kernel::Segment_3(b[1], b[2])) ||
         CGAL::do_intersect(other, Kernel::Segment_3(a[1], a[2]));
}

bool are_in_conflict(const Side& first, const Side& second) {
  return boxes_meet(first, second) && first.has_area && second.has_area &&
         intersect<Same::place>(first, second);
}

std::vector<Side> sides_of(std::span<const Vector3<double>> points,
                           std::span<const PatchTriangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(triangles.size());
  for (const auto& t : triangles) sides.push_back(side_of(points, t));
  return sides;
}

/// The axis along which boxes overlap least, for their size.
std::size_t axis_of(const std::vector<Side>& sides) {
  std::array<double, 3> overlap{};
  for (std::size_t k = 0; k < 3; ++k) {
    double low = HUGE_VAL, high = -HUGE_VAL, sum = 0;
    for (const auto& s : sides) {
      low = std::min(low, s.low[k]), high = std::max(high, s.high[k]);
      sum += s.high[k] - s.low[k];
    }
    overlap[k] = high > low ? sum / (high - low) : HUGE_VAL;
  }
  return static_cast<std::size_t>(std::min_element(overlap.begin(), overlap.end()) -
                                  overlap.begin());
}

/// Calls f for any two of these whose boxes, `low` to `high`, meet.
template <class Boxes, class F>
void for_meeting(const Boxes& all, const F& f) {
  using Handle = decltype(&*all.begin());
  using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, Handle>;
  std::vector<Box> boxes;
  boxes.reserve(all.size());
  for (const auto& s : all)
    boxes.emplace_back(
        CGAL::Bbox_3(s.low[0], s.low[1], s.low[2], s.high[0], s.high[1], s.high[2]), &s);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& p, const Box& q) {
    f(*p.handle(), *q.handle());
  });
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> intersecting_pairs(
    std::span<const Vector3<double>> points, std::span<const PatchTriangle> triangles) {
  const auto sides = sides_of(points, triangles);
  const std::size_t axis = axis_of(sides);
  std::vector<std::uint32_t> order(sides.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(sides[i].low[axis], i) < std::pair(sides[j].low[axis], j);
  });
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const auto &s = sides[order[i]], &t = sides[order[j]];
      if (t.low[axis] > s.high[axis]) break;
      if (!are_in_conflict(s, t)) continue;
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
      if (are_in_conflict(sides[i], sides[j])) return true;
  for (const auto& t : others) {
    const Side side = side_of(points, t);
    for (const auto& s : sides)
      if (are_in_conflict(s, side)) return true;
  }
  return false;
}

bool are_embedded(std::span<const Vector3<double>> points,
                  std::span<const PatchTriangle> triangles) {
  const auto sides = sides_of(points, triangles);
  if (!std::all_of(sides.begin(), sides.end(), [](const Side& s) { return s.has_area; }))
    return false;
  bool all = true;
  for_meeting(sides, [&](const Side& s, const Side& t) {
    all = all && !intersect<Same::number>(s, t);
  });
  return all;
}

std::vector<std::array<std::uint32_t, 2>> meeting_boxes(std::span<const AxisBox> boxes) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for_meeting(boxes, [&](const AxisBox& s, const AxisBox& t) {
    const auto place = [&](const AxisBox& b) {
      return static_cast<std::uint32_t>(&b - boxes.data());
    };
    pairs.push_back({place(s), place(t)});
  });
  return pairs;
}

}  // namespace tensortopo
