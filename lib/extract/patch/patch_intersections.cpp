// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/patch_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "tensortopo/mesh/box_tree.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::size_t kPart = 1024;  ///< boxes that one thread takes at a time

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

AxisBox box_of(std::span<const Vector3<double>> points, const PatchTriangle& t) {
  AxisBox box;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& p = points[t[i]];
    const std::array<double, 3> x{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = i == 0 ? x[k] : std::min(box.low[k], x[k]);
      box.high[k] = i == 0 ? x[k] : std::max(box.high[k], x[k]);
    }
  }
  return box;
}

Side side_of(std::span<const Vector3<double>> points, const PatchTriangle& t) {
  Side side{};
  side.places = t;
  const AxisBox box = box_of(points, t);
  side.low = box.low, side.high = box.high;
  for (std::size_t i = 0; i < 3; ++i) side.corners[i] = points[t[i]];
  const auto u = side.corners[1] - side.corners[0], v = side.corners[2] - side.corners[0];
  side.normal = cross(u, v);
  side.error = kRoundings * largest(u) * largest(v);
  side.has_area = largest(side.normal) > side.error + kUnderflow || !are_collinear(side.corners);
  return side;
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

void make_sides(std::span<const Vector3<double>> points, std::span<const PatchTriangle> triangles,
                std::vector<Side>& sides) {
  sides.clear();
  sides.reserve(triangles.size());
  for (const auto& t : triangles) sides.push_back(side_of(points, t));
}

/// The longest of some differences between corners and a point, as `part` sees them, with its largest
/// coordinate made 1; zero if all are.
template <class Part>
Vector3<double> longest(const std::vector<Side>& sides, const Vector3<double>& from,
                        const Part& part) {
  Vector3<double> result{};
  for (const auto& s : sides)
    for (const auto& p : s.corners)
      if (const auto d = part(p - from); largest(d) > largest(result)) result = d;
  const double size = largest(result);
  return size > 0 ? (1 / size) * result : result;
}

/// Three directions of the patch: that in which it is longest, the next one, and one across both.
/// They are about orthogonal, and exact as they are.
std::array<Vector3<double>, 3> directions_of(const std::vector<Side>& sides) {
  const Vector3<double>& first = sides[0].corners[0];
  Vector3<double> from = first;
  for (const auto& s : sides)
    for (const auto& p : s.corners)
      if (largest(p - first) > largest(from - first)) from = p;
  const auto along = longest(sides, from, [](const auto& d) { return d; });
  if (largest(along) == 0) return {};
  const auto beside = longest(sides, from, [&](const auto& d) {
    return d - (dot(along, d) / dot(along, along)) * along;
  });
  return {along, beside, cross(along, beside)};
}

/// For each triangle intervals that hold its points' products with the directions of the patch:
/// boxes along the axes overlap wherever triangles around a thin tube are oblique to these. Rounding
/// is allowed for as in `kRoundings`.
void make_extents(const std::vector<Side>& sides, std::vector<AxisBox>& extents) {
  extents.clear();
  if (sides.empty()) return;
  const Vector3<double>& from = sides[0].corners[0];
  const auto directions = directions_of(sides);
  for (const auto& s : sides) {
    AxisBox extent{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (const auto& p : s.corners)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto d = p - from;
        const double place = dot(directions[k], d);
        const double error = kRoundings * largest(directions[k]) * largest(d) + kUnderflow;
        extent.low[k] = std::min(extent.low[k], place - error);
        extent.high[k] = std::max(extent.high[k], place + error);
      }
    extents.push_back(extent);
  }
}

/// Calls the body for the parts of 0 to count - 1, in parallel, with the rounding that predicates
/// need.
template <class Body>
void for_parts(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kPart), [&](const auto& range) {
    const FloatingPointEnvironment environment;
    body(range.begin(), range.end());
  });
}

}  // namespace

IntersectingPairs intersecting_pairs(std::span<const Vector3<double>> points,
                                     std::span<const PatchTriangle> triangles,
                                     std::size_t most_tested) {
  // Nearly all patches are small: no memory for each of them.
  thread_local std::vector<Side> sides;
  make_sides(points, triangles, sides);
  thread_local std::vector<AxisBox> extents;
  make_extents(sides, extents);
  thread_local std::vector<std::uint32_t> order;
  order.resize(sides.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(extents[i].low[0], i) < std::pair(extents[j].low[0], j);
  });
  IntersectingPairs result;
  for (std::size_t i = 0; i < order.size() && result.are_all; ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (extents[order[j]].low[0] > extents[order[i]].high[0]) break;
      if (!boxes_meet(extents[order[i]], extents[order[j]])) continue;
      if (result.tested >= most_tested && !result.pairs.empty()) {
        result.are_all = false;
        break;
      }
      ++result.tested;
      if (!are_in_conflict(sides[order[i]], sides[order[j]])) continue;
      const auto [a, b] = std::minmax(order[i], order[j]);
      result.pairs.push_back({a, b});
    }
  std::sort(result.pairs.begin(), result.pairs.end());
  return result;
}

std::optional<std::size_t> find_intersection(std::span<const Vector3<double>> points,
                                             std::span<const PatchTriangle> first,
                                             std::span<const PatchTriangle> others) {
  thread_local std::vector<Side> sides;
  make_sides(points, first, sides);
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j)
      if (are_in_conflict(sides[i], sides[j])) return others.size();
  for (std::size_t other = 0; other < others.size(); ++other) {
    const AxisBox box = box_of(points, others[other]);
    if (std::none_of(sides.begin(), sides.end(), [&](const Side& s) { return boxes_meet(s, box); }))
      continue;
    const Side side = side_of(points, others[other]);
    for (const auto& s : sides)
      if (are_in_conflict(s, side)) return other;
  }
  return std::nullopt;
}

bool intersects_any(std::span<const Vector3<double>> points, std::span<const PatchTriangle> first,
                    std::span<const PatchTriangle> others) {
  return find_intersection(points, first, others).has_value();
}

bool are_embedded(std::span<const Vector3<double>> points,
                  std::span<const PatchTriangle> triangles) {
  std::vector<Side> sides(triangles.size());
  std::vector<AxisBox> boxes(triangles.size());
  std::atomic<bool> is_embedded{true};
  for_parts(sides.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      sides[i] = side_of(points, triangles[i]);
      boxes[i] = {sides[i].low, sides[i].high};
      if (!sides[i].has_area) is_embedded = false;
    }
  });
  if (!is_embedded) return false;
  const BoxTree tree(boxes);
  for_parts(tree.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t rank = begin; rank < end && is_embedded; ++rank)
      if (tree.any_meeting(rank, [&](std::uint32_t i, std::uint32_t j) {
            return intersect<Same::number>(sides[i], sides[j]);
          }))
        is_embedded = false;
  });
  return is_embedded;
}

}  // namespace tensortopo
