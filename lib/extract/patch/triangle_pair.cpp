// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/triangle_pair.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>

#include <cstddef>
#include <utility>

namespace tensortopo::detail {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Vector3<double>& p) { return {p.x, p.y, p.z}; }

bool are_collinear(const std::array<Vector3<double>, 3>& c) {
  return CGAL::collinear(point(c[0]), point(c[1]), point(c[2]));
}

/// Whether doubles show that a point is on one side of the plane of a triangle: 1 or -1, else 0.
int side_in_doubles(const Side& plane, const Vector3<double>& p) {
  const auto d = p - plane.corners[0];
  const double value = dot(plane.normal, d);
  const double error = plane.error * largest(d) + kUnderflow;
  return value > error ? 1 : value < -error ? -1 : 0;
}

/// The sides of a plane on which doubles show that corners are.
std::array<int, 3> sides_in_doubles(const Side& plane,
                                    const std::array<Vector3<double>, 3>& corners) {
  return {side_in_doubles(plane, corners[0]), side_in_doubles(plane, corners[1]),
          side_in_doubles(plane, corners[2])};
}

/// Whether the corners from one on, in an order, are shown to be on one side.
bool are_apart(const std::array<int, 3>& sides, const std::array<std::size_t, 3>& order,
               std::size_t from) {
  for (std::size_t i = from; i < 3; ++i)
    if (sides[order[i]] == 0 || sides[order[i]] != sides[order[from]]) return false;
  return true;
}

}  // namespace

Side side_of(std::span<const Vector3<double>> points, const PatchTriangle& t) {
  Side side{};
  side.places = t;
  for (std::size_t i = 0; i < 3; ++i) side.corners[i] = points[t[i]];
  const AxisBox box = box_of(side.corners);
  side.low = box.low, side.high = box.high;
  const auto u = side.corners[1] - side.corners[0], v = side.corners[2] - side.corners[0];
  side.normal = cross(u, v);
  side.error = kRoundings * largest(u) * largest(v) + kNormalUnderflow;
  side.has_area = largest(side.normal) > side.error + kUnderflow || !are_collinear(side.corners);
  return side;
}

/// What two triangles with an area have in common is convex: if it is more than a common corner it
/// goes on from there to the opposite side of one of the two.
template <Same same>
bool intersect(const Side& first, const Side& second) {
  // Most pairs are apart and share nothing.
  const auto of_second = sides_in_doubles(first, second.corners);
  if (are_apart(of_second, {0, 1, 2}, 0)) return false;
  const auto of_first = sides_in_doubles(second, first.corners);
  if (are_apart(of_first, {0, 1, 2}, 0)) return false;
  std::array<std::size_t, 3> i{0, 1, 2}, j{0, 1, 2};
  std::size_t shared = 0;  // moved to the front
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t l = shared; l < 3; ++l) {
      const bool are_same = same == Same::number ? first.places[i[l]] == second.places[j[k]]
                                                 : first.corners[i[l]] == second.corners[j[k]];
      if (!are_same) continue;
      std::swap(i[shared], i[l]), std::swap(j[shared], j[k]);
      ++shared;
      break;
    }
  if (shared == 3) return true;
  if (are_apart(of_second, j, shared) || are_apart(of_first, i, shared)) return false;
  const std::array s{first.corners[i[0]], first.corners[i[1]], first.corners[i[2]]},
      t{second.corners[j[0]], second.corners[j[1]], second.corners[j[2]]};
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

template bool intersect<Same::place>(const Side&, const Side&);
template bool intersect<Same::number>(const Side&, const Side&);

}  // namespace tensortopo::detail
