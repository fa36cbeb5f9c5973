// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/constrained_delaunay.hpp"

// CGAL's kernel and its sorting are LGPL, its triangulations GPL. Debian 12 has no constrained
// triangulation with exact predicates under another licence: VTK's decides by a tolerance.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "extract/run/assert.hpp"

namespace tensortopo {

namespace {

using Index = ConstrainedDelaunay::Index;
using Point = ConstrainedDelaunay::Point;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 place(const Point& p) { return {p[0], p[1]}; }

/// Along the list while it is short: neighbours are near. Long outlines would so take squared time,
/// each point undoing many triangles of those before it; in a random order few are undone.
std::vector<std::size_t> order_of_insertion(std::span<const Point> points) {
  constexpr std::size_t short_outline = 256;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (order.size() <= short_outline) return order;
  std::vector<Kernel::Point_2> places;
  places.reserve(points.size());
  for (const auto& p : points) places.push_back(place(p));
  using Traits = CGAL::Spatial_sort_traits_adapter_2<
      Kernel, CGAL::Pointer_property_map<Kernel::Point_2>::const_type>;
  const auto& sorted = places;
  CGAL::spatial_sort(order.begin(), order.end(), Traits(CGAL::make_property_map(sorted)));
  return order;
}

}  // namespace

bool ConstrainedDelaunay::insert(std::span<const Point> points) {
  const std::size_t first = points_.size();
  for (const auto& p : points)
    if (!std::isfinite(p[0]) || !std::isfinite(p[1])) return false;
  if (points.size() > 1) {
    points_.reserve(first + points.size());
    triangle_at_.reserve(first + points.size());
    triangles_.reserve(2 * (first + points.size()));
  }
  points_.insert(points_.end(), points.begin(), points.end());
  triangle_at_.resize(points_.size(), kNone);
  if (points.size() == 1) return insert_vertex(static_cast<Index>(first));
  const auto order = order_of_insertion(points);
  return std::all_of(order.begin(), order.end(),
                     [&](std::size_t i) { return insert_vertex(static_cast<Index>(first + i)); });
}

Index ConstrainedDelaunay::locate(const Point& at) {
  if (triangles_.empty()) return kNone;
  return near_ = find(at).side.triangle;
}

bool ConstrainedDelaunay::insert_vertex(Index v) {
  if (triangles_.empty()) {
    if (lone_ != kNone && points_[lone_] == points_[v]) return false;
    if (lone_ == kNone)
      lone_ = v;
    else
      start_line(v);
    return true;
  }
  const Location found = find(points_[v]);
  switch (found.where) {
    case Where::vertex:
      return false;
    case Where::face:
      split_face(found.side.triangle, v);
      break;
    case Where::edge:
      split_edge(found.side, v);
      break;
    case Where::outside:
      join_to_hull(v, found.side.triangle);
      break;
    case Where::beyond_line:
      prolong_line(v, found.side);
      break;
  }
  flip_around(v);
  near_ = triangle_at_[v];
  return true;
}

// Places.

int ConstrainedDelaunay::turn(Index a, Index b, const Point& c) const {
  return static_cast<int>(CGAL::orientation(place(points_[a]), place(points_[b]), place(c)));
}

/// Visibility may lead in a circle, as constrained edges are no Delaunay edges.
ConstrainedDelaunay::Location ConstrainedDelaunay::find(const Point& at) const {
  if (on_line_) return find_on_line(at);
  Index t = near_;
  if (is_infinite(triangles_[t])) t = triangles_[t].neighbours[corner_of(t, kInfinite)];
  std::uint32_t from = 3;
  for (std::size_t steps = 0; steps < triangles_.size(); ++steps) {
    const Triangle& triangle = triangles_[t];
    std::uint32_t zeros = 0, on = 0, off = 0, i = 0;
    for (; i < 3; ++i) {
      const int side = i == from ? 1
                                 : turn(triangle.corners[next(i)], triangle.corners[previous(i)], at);
      if (side < 0) break;
      (side == 0 ? on : off) = i;
      zeros += side == 0 ? 1 : 0;
    }
    if (i == 3)
      return zeros == 0   ? Location{Where::face, {t, 0}}
             : zeros == 1 ? Location{Where::edge, {t, on}}
                          : Location{Where::vertex, {t, off}};
    const Side across = mirror({t, i});
    t = across.triangle;
    from = across.corner;
    if (is_infinite(triangles_[t])) return {Where::outside, {t, from}};
  }
  return find_among_all(at);
}

ConstrainedDelaunay::Location ConstrainedDelaunay::find_among_all(const Point& at) const {
  for (Index t = 0; t < triangles_.size(); ++t) {
    const Triangle& triangle = triangles_[t];
    std::uint32_t positive = 0, on = 0, off = 0;
    bool is_outside = false;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Index a = triangle.corners[next(i)], b = triangle.corners[previous(i)];
      const int side = a == kInfinite || b == kInfinite ? 1 : turn(a, b, at);
      is_outside |= side < 0;
      (side == 0 ? on : off) = i;
      positive += side > 0 ? 1 : 0;
    }
    if (is_outside) continue;
    if (is_infinite(triangle)) {
      if (positive == 3) return {Where::outside, {t, corner_of(t, kInfinite)}};
    } else {
      return positive == 3   ? Location{Where::face, {t, 0}}
             : positive == 2 ? Location{Where::edge, {t, on}}
                             : Location{Where::vertex, {t, off}};
    }
  }
  TENSORTOPO_ASSERT(false, "triangles cover the plane");
  return {};
}

ConstrainedDelaunay::Location ConstrainedDelaunay::find_on_line(const Point& at) const {
  for (Index t = near_;;) {
    const std::uint32_t i = corner_of(t, kInfinite);
    const Index a = triangles_[t].corners[next(i)], b = triangles_[t].corners[previous(i)];
    const Point &p = points_[a], &q = points_[b];
    if (const int side = turn(a, b, at); side != 0)
      return {Where::outside, side > 0 ? Side{t, i} : mirror({t, i})};
    if (at == p || at == q) return {Where::vertex, {t, i}};
    const bool is_after_a = (p < q) == (p < at), is_before_b = (p < q) == (at < q);
    if (is_after_a && is_before_b) return {Where::edge, {t, i}};
    const std::uint32_t ahead = is_after_a ? next(i) : previous(i);
    const Index beyond = triangles_[t].neighbours[ahead];
    if (beyond == triangles_[t].neighbours[i]) return {Where::beyond_line, {t, ahead}};
    t = beyond;
  }
}

// Points.

void ConstrainedDelaunay::start_line(Index v) {
  const Index s = add(kInfinite, lone_, v), t = add(kInfinite, v, lone_);
  link({s, 0}, {t, 0});
  link({s, 1}, {t, 2});
  link({s, 2}, {t, 1});
  near_ = s;
}

/// Two triangles between the ones that meet in the edge.
void ConstrainedDelaunay::prolong_line(Index v, Side end) {
  const Side other = mirror(end);
  const Index a = triangles_[end.triangle].corners[next(end.corner)];
  const Index b = triangles_[end.triangle].corners[previous(end.corner)];
  const Index s = add(v, b, a), t = add(v, a, b);
  link({s, 0}, end);
  link({t, 0}, other);
  link({s, 1}, {t, 2});
  link({s, 2}, {t, 1});
}

void ConstrainedDelaunay::split_face(Index t, Index v) {
  const Triangle old = triangles_[t];
  const auto& [a, b, c] = old.corners;
  const std::array<Side, 3> outer{mirror({t, 0}), mirror({t, 1}), mirror({t, 2})};
  const std::array<Index, 3> parts{t, add(v, c, a), add(v, a, b)};
  set(t, v, b, c);
  for (std::uint32_t i = 0; i < 3; ++i) {
    link({parts[i], 0}, outer[i], old.constrained[i]);
    link({parts[i], 1}, {parts[next(i)], 2});
  }
}

void ConstrainedDelaunay::split_edge(Side side, Index v) {
  const Side other = mirror(side);
  const Index s = side.triangle, t = other.triangle;
  const std::uint32_t i = side.corner, j = other.corner;
  const bool is_constrained = constrained(side);
  const Index c = triangles_[s].corners[i], a = triangles_[s].corners[next(i)],
              b = triangles_[s].corners[previous(i)], d = triangles_[t].corners[j];
  std::array<Side, 4> outer{mirror({s, next(i)}), mirror({s, previous(i)}),
                                  mirror({t, next(j)}), mirror({t, previous(j)})};
  std::array<bool, 4> flags{};
  for (std::size_t k = 0; k < 4; ++k) flags[k] = constrained(outer[k]);
  // Around v: b c, c a, a d, d b.
  const std::array<Index, 4> parts{s, add(v, c, a), t, add(v, d, b)};
  // At the end of a line the two triangles have one more edge in common.
  for (std::size_t k = 0; k < 4; ++k)
    if (outer[k].triangle == s || outer[k].triangle == t) outer[k] = {parts[3 - k], 0};
  set(s, v, b, c);
  set(t, v, a, d);
  for (std::uint32_t k = 0; k < 4; ++k) {
    link({parts[k], 0}, outer[k], flags[k]);
    // The edges from v to c, a, d, b.
    link({parts[k], 1}, {parts[(k + 1) % 4], 2}, k % 2 == 1 && is_constrained);
  }
}

/// The outer triangles whose edges are seen from the point get it as their corner.
void ConstrainedDelaunay::join_to_hull(Index v, Index visible) {
  const auto sees = [&](Index t) {
    const std::uint32_t i = corner_of(t, kInfinite);
    return turn(triangles_[t].corners[next(i)], triangles_[t].corners[previous(i)], v) > 0;
  };
  const auto beside = [&](Index t, bool is_ahead) {
    const std::uint32_t i = corner_of(t, kInfinite);
    return mirror({t, is_ahead ? next(i) : previous(i)});
  };
  Index first = visible, last = visible;
  while (sees(beside(first, false).triangle)) first = beside(first, false).triangle;
  while (sees(beside(last, true).triangle)) last = beside(last, true).triangle;
  const Side before = beside(first, false), after = beside(last, true);
  for (Index t = first;; ) {
    const Index following = beside(t, true).triangle;
    const std::uint32_t i = corner_of(t, kInfinite);
    triangles_[t].corners[i] = v;
    triangle_at_[v] = t;
    if (t == last) break;
    t = following;
  }
  const std::uint32_t i = corner_of(first, v), j = corner_of(last, v);
  const Index s = add(kInfinite, triangles_[first].corners[next(i)], v);
  const Index t = add(kInfinite, v, triangles_[last].corners[previous(j)]);
  link({s, 0}, {first, previous(i)});
  link({t, 0}, {last, next(j)});
  link({s, 1}, {t, 2});
  link({s, 2}, before);
  link({t, 1}, after);
  on_line_ = false;
}

// Flips.

/// Whether the diagonal of the two triangles at an edge should be the other one. If so, they form a
/// strictly convex quadrilateral.
bool ConstrainedDelaunay::wants_flip(Side side) const {
  const Triangle& t = triangles_[side.triangle];
  if (t.constrained[side.corner]) return false;
  const Index d = triangles_[t.neighbours[side.corner]].corners[mirror(side).corner];
  const Index p = t.corners[side.corner], a = t.corners[next(side.corner)],
              b = t.corners[previous(side.corner)];
  if (p == kInfinite || a == kInfinite || b == kInfinite || d == kInfinite) return false;
  const auto position = CGAL::side_of_oriented_circle(place(points_[p]), place(points_[a]),
                                                      place(points_[b]), place(points_[d]));
  if (position != CGAL::ON_ORIENTED_BOUNDARY) return position == CGAL::ON_POSITIVE_SIDE;
  return std::max(a, b) > std::max(p, d);
}

/// Afterwards the side's corner is corner 0 of both triangles, and the edges that were not flipped
/// are 0 and 2 of the first, 0 and 1 of the second.
void ConstrainedDelaunay::flip(Side side) {
  const Side other = mirror(side);
  const Index t = side.triangle, u = other.triangle;
  const std::uint32_t i = side.corner, j = other.corner;
  const Index p = triangles_[t].corners[i], a = triangles_[t].corners[next(i)],
              b = triangles_[t].corners[previous(i)], d = triangles_[u].corners[j];
  // u is d, b, a.
  const Side pa = mirror({t, previous(i)}), bp = mirror({t, next(i)});
  const Side db = mirror({u, previous(j)}), ad = mirror({u, next(j)});
  const bool is_pa = constrained(pa), is_bp = constrained(bp), is_db = constrained(db),
             is_ad = constrained(ad);
  set(t, p, a, d);
  set(u, p, d, b);
  link({t, 0}, ad, is_ad);
  link({t, 2}, pa, is_pa);
  link({t, 1}, {u, 2});
  link({u, 0}, db, is_db);
  link({u, 1}, bp, is_bp);
}

/// Of edges opposite a new vertex, and those that come to be so.
void ConstrainedDelaunay::flip_around(Index v) {
  Index t = triangle_at_[v];
  if (t == kNone || on_line_) return;
  do {
    const std::uint32_t i = corner_of(t, v);
    to_check_.push_back({t, i});
    t = triangles_[t].neighbours[next(i)];
  } while (t != triangle_at_[v]);
  while (!to_check_.empty()) {
    const Side side = to_check_.back();
    to_check_.pop_back();
    if (!wants_flip(side)) continue;
    const Index u = triangles_[side.triangle].neighbours[side.corner];
    flip(side);
    to_check_.push_back({side.triangle, 0});
    to_check_.push_back({u, 0});
  }
}

void ConstrainedDelaunay::flip_all() {
  while (!to_check_.empty()) {
    const Side side = to_check_.back();
    to_check_.pop_back();
    if (!wants_flip(side)) continue;
    const Index t = side.triangle, u = triangles_[t].neighbours[side.corner];
    flip(side);
    for (const Side s : {Side{t, 0}, Side{t, 2}, Side{u, 0}, Side{u, 1}}) to_check_.push_back(s);
  }
}

// Links.

void ConstrainedDelaunay::set(Index t, Index a, Index b, Index c) {
  triangles_[t] = {{a, b, c}, {kNone, kNone, kNone}, {false, false, false}, 0};
  for (const Index v : {a, b, c}) (v == kInfinite ? infinite_ : triangle_at_[v]) = t;
}

Index ConstrainedDelaunay::add(Index a, Index b, Index c) {
  triangles_.emplace_back();
  const auto t = static_cast<Index>(triangles_.size() - 1);
  set(t, a, b, c);
  return t;
}

void ConstrainedDelaunay::link(Side s, Side t) {
  triangles_[s.triangle].neighbours[s.corner] = t.triangle;
  triangles_[t.triangle].neighbours[t.corner] = s.triangle;
}

void ConstrainedDelaunay::link(Side s, Side t, bool is_constrained) {
  link(s, t);
  constrained(s) = constrained(t) = is_constrained;
}

/// The same edge from the other side. (On a line two triangles have two edges in common.)
ConstrainedDelaunay::Side ConstrainedDelaunay::mirror(Side side) const {
  const Triangle& t = triangles_[side.triangle];
  const Index u = t.neighbours[side.corner];
  return {u, next(corner_of(u, t.corners[next(side.corner)]))};
}

std::uint32_t ConstrainedDelaunay::corner_of(Index t, Index v) const {
  const auto& corners = triangles_[t].corners;
  return corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
}

}  // namespace tensortopo
