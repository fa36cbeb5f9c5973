// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "embedding/surface_defects.hpp"

namespace tensortopo::embedding {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const std::size_t*>;
using Corners = std::array<std::size_t, 3>;  ///< places

class Intersector {
 public:
  explicit Intersector(const Surface& surface) : surface_(surface) {
    std::map<Point, std::size_t> number;
    for (const auto& p : surface.points) {
      const auto [found, added] = number.try_emplace(p, number.size());
      place_.push_back(found->second);
      if (added) points_.emplace_back(p[0], p[1], p[2]);
    }
    find_sheets();
  }

  Intersections run() {
    Intersections result;
    std::vector<std::size_t> ids(surface_.triangles.size());
    std::iota(ids.begin(), ids.end(), std::size_t{0});
    std::vector<Box> boxes;
    for (const auto& id : ids) {
      const auto t = corners(id);
      if (CGAL::collinear(points_[t[0]], points_[t[1]], points_[t[2]]))
        ++result.without_area;
      else
        boxes.emplace_back(triangle(t).bbox(), &id);
    }
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      const auto i = std::min(*a.handle(), *b.handle()), j = std::max(*a.handle(), *b.handle());
      ++result.compared;
      if (!intersect(corners(i), corners(j))) return;
      using Where = Intersection::Where;
      const auto where = surface_.tet[i] != surface_.tet[j] ? Where::two_tets
                         : sheet_[i] != sheet_[j]           ? Where::two_sheets
                                                            : Where::one_sheet;
      result.pairs.push_back({i, j, where});
    });
    std::sort(result.pairs.begin(), result.pairs.end(), [](const auto& p, const auto& q) {
      return std::pair(p.first, p.second) < std::pair(q.first, q.second);
    });
    return result;
  }

 private:
  Corners corners(std::size_t t) const {
    const auto& v = surface_.triangles[t];
    const auto at = [&](std::size_t i) { return place_[static_cast<std::size_t>(v[i])]; };
    return {at(0), at(1), at(2)};
  }

  Kernel::Triangle_3 triangle(const Corners& t) const {
    return {points_[t[0]], points_[t[1]], points_[t[2]]};
  }

  /// Of triangles with area. The common part of two triangles is convex: if it is more than a
  /// common corner, it goes on from there to a side opposite to it, of the one or the other.
  bool intersect(Corners s, Corners t) const {
    std::size_t shared = 0;  // moved to the front
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = shared; j < 3; ++j)
        if (s[j] == t[i]) {
          std::swap(s[shared], s[j]), std::swap(t[shared], t[i]);
          ++shared;
          break;
        }
    const auto &a = points_[s[1]], &b = points_[s[2]], &c = points_[t[1]], &d = points_[t[2]];
    switch (shared) {
      case 0:
        return CGAL::do_intersect(triangle(s), triangle(t));
      case 1:
        return CGAL::do_intersect(triangle(s), Kernel::Segment_3(c, d)) ||
               CGAL::do_intersect(triangle(t), Kernel::Segment_3(a, b));
      case 2:
        return CGAL::coplanar(points_[s[0]], a, b, d) &&
               CGAL::coplanar_orientation(points_[s[0]], a, b, d) == CGAL::POSITIVE;
      default:
        return true;
    }
  }

  /// Triangles of one tetrahedron that are joined by vertices form a sheet.
  void find_sheets() {
    const auto count = surface_.triangles.size();
    std::vector<std::size_t> parent(count);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
      while (parent[i] != i) i = parent[i] = parent[parent[i]];
      return i;
    };
    std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> at;
    for (std::size_t i = 0; i < count; ++i)
      for (const auto v : surface_.triangles[i]) {
        const auto [found, added] = at.try_emplace({surface_.tet[i], v}, i);
        if (!added) parent[find(i)] = find(found->second);
      }
    for (std::size_t i = 0; i < count; ++i) sheet_.push_back(find(i));
  }

  const Surface& surface_;
  std::vector<std::size_t> place_;  ///< of each vertex
  std::vector<Kernel::Point_3> points_;
  std::vector<std::size_t> sheet_;  ///< of each triangle
};

}  // namespace

Intersections intersections(const Surface& surface) { return Intersector(surface).run(); }

}  // namespace tensortopo::embedding
