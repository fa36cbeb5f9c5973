// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/delaunay/constrained_delaunay.hpp"

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
  using Traits =
      CGAL::Spatial_sort_traits_adapter_2<Kernel,
                                          CGAL::Pointer_property_map<Kernel::Point_2>::const_type>;
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
  return near_ = find(at).side.triangle();
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
      split_face(found.side.triangle(), v);
      break;
    case Where::edge:
      split_edge(found.side, v);
      break;
    case Where::outside:
      join_to_hull(v, found.side);
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
  if (is_infinite(triangles_[t])) t = mirror({t, corner_of(t, kInfinite)}).triangle();
  std::uint32_t from = 3;
  for (std::size_t steps = 0; steps < triangles_.size(); ++steps) {
    const Triangle& triangle = triangles_[t];
    std::uint32_t zeros = 0, on = 0, off = 0, i = 0;
    for (; i < 3; ++i) {
      const int side =
          i == from ? 1 : turn(triangle.corners[next(i)], triangle.corners[previous(i)], at);
      if (side < 0) break;
      (side == 0 ? on : off) = i;
      zeros += side == 0 ? 1 : 0;
    }
    if (i == 3)
      return zeros == 0   ? Location{Where::face, {t, 0}}
             : zeros == 1 ? Location{Where::edge, {t, on}}
                          : Location{Where::vertex, {t, off}};
    const Side across = triangle.beyond[i];
    if (tip_of(across) == kInfinite) return {Where::outside, across};
    t = across.triangle();
    from = across.corner();
  }
  return find_among_all(at);
}

ConstrainedDelaunay::Location ConstrainedDelaunay::find_among_all(const Point& at) const {
  for (Index t = 0; t < triangles_.size(); ++t) {
    std::uint32_t positive = 0, on = 0, off = 0;
    bool is_outside = false;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Index a = start_of({t, i}), b = end_of({t, i});
      const int side = a == kInfinite || b == kInfinite ? 1 : turn(a, b, at);
      is_outside |= side < 0;
      (side == 0 ? on : off) = i;
      positive += side > 0 ? 1 : 0;
    }
    if (is_outside) continue;
    if (is_infinite(triangles_[t])) {
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
    const Side piece{t, corner_of(t, kInfinite)};
    const Index a = start_of(piece), b = end_of(piece);
    const Point &p = points_[a], &q = points_[b];
    if (const int side = turn(a, b, at); side != 0)
      return {Where::outside, side > 0 ? piece : mirror(piece)};
    if (at == p || at == q) return {Where::vertex, piece};
    const bool is_after_a = (p < q) == (p < at), is_before_b = (p < q) == (at < q);
    if (is_after_a && is_before_b) return {Where::edge, piece};
    const Side ahead{t, is_after_a ? next(piece.corner()) : previous(piece.corner())};
    t = mirror(ahead).triangle();
    if (t == mirror(piece).triangle()) return {Where::beyond_line, ahead};
  }
}

// Points.

void ConstrainedDelaunay::start_line(Index v) {
  const Index s = add(kInfinite, lone_, v), t = add(kInfinite, v, lone_);
  link({s, 0}, {t, 0}, false);
  link({s, 1}, {t, 2}, false);
  link({s, 2}, {t, 1}, false);
  near_ = s;
}

/// Two triangles between the ones that meet in the edge.
void ConstrainedDelaunay::prolong_line(Index v, Side end) {
  const Side other = mirror(end);
  const Index a = start_of(end), b = end_of(end);
  const Index s = add(v, b, a), t = add(v, a, b);
  link({s, 0}, end, false);
  link({t, 0}, other, false);
  link({s, 1}, {t, 2}, false);
  link({s, 2}, {t, 1}, false);
}

void ConstrainedDelaunay::split_face(Index t, Index v) {
  const Triangle old = triangles_[t];
  const auto& [a, b, c] = old.corners;
  const std::array<Index, 3> parts{t, add(v, c, a), add(v, a, b)};
  set(t, v, b, c);
  for (std::uint32_t i = 0; i < 3; ++i) {
    link({parts[i], 0}, old.beyond[i], old.constrained[i]);
    link({parts[i], 1}, {parts[next(i)], 2}, false);
  }
}

void ConstrainedDelaunay::split_edge(Side side, Index v) {
  const Side other = mirror(side);
  const Index s = side.triangle(), t = other.triangle();
  const Index c = tip_of(side), a = start_of(side), b = end_of(side), d = tip_of(other);
  const bool is_constrained = constrained(side);
  has_split_segments_ |= is_constrained;
  const std::array<Side, 4> inner{Side{s, next(side.corner())}, Side{s, previous(side.corner())},
                                  Side{t, next(other.corner())}, Side{t, previous(other.corner())}};
  std::array<Side, 4> outer;
  std::array<bool, 4> flags{};
  for (std::size_t k = 0; k < 4; ++k) {
    outer[k] = mirror(inner[k]);
    flags[k] = constrained(inner[k]);
  }
  // Around v: b c, c a, a d, d b.
  const std::array<Index, 4> parts{s, add(v, c, a), t, add(v, d, b)};
  set(s, v, b, c);
  set(t, v, a, d);
  for (std::uint32_t k = 0; k < 4; ++k) {
    // At the end of a line the two triangles have one more edge in common.
    const bool is_shared = outer[k] == inner[3 - k];
    link({parts[k], 0}, is_shared ? Side{parts[3 - k], 0} : outer[k], flags[k]);
    // The edges from v to c, a, d, b.
    link({parts[k], 1}, {parts[(k + 1) % 4], 2}, k % 2 == 1 && is_constrained);
  }
}

/// The outer triangles whose edges are seen from the point get it as their corner.
void ConstrainedDelaunay::join_to_hull(Index v, Side visible) {
  // Each side is opposite `kInfinite`.
  const auto ahead = [&](Side s) { return mirror({s.triangle(), next(s.corner())}); };
  const auto behind = [&](Side s) { return mirror({s.triangle(), previous(s.corner())}); };
  const auto following = [&](Side s) { return Side{s.triangle(), next(s.corner())}; };
  const auto preceding = [&](Side s) { return Side{s.triangle(), previous(s.corner())}; };
  const auto sees = [&](Side s) { return turn(start_of(s), end_of(s), v) > 0; };
  Side first = visible, last = visible;
  for (Side s = visible; sees(s); s = preceding(behind(s))) first = s;
  for (Side s = visible; sees(s); s = following(ahead(s))) last = s;
  const Side before = behind(first), after = ahead(last);
  for (Side s = first;;) {
    const Side upcoming = following(ahead(s));
    triangles_[s.triangle()].corners[s.corner()] = v;
    if (s == last) break;
    s = upcoming;
  }
  triangle_at_[v] = first.triangle();
  const Index s = add(kInfinite, start_of(first), v), t = add(kInfinite, v, end_of(last));
  link({s, 0}, preceding(first), false);
  link({t, 0}, following(last), false);
  link({s, 1}, {t, 2}, false);
  link({s, 2}, before, false);
  link({t, 1}, after, false);
  on_line_ = false;
}

// Flips.

/// Whether the diagonal of the two triangles at an edge should be the other one. If so, they form a
/// strictly convex quadrilateral.
bool ConstrainedDelaunay::wants_flip(Side side) const {
  const Triangle& t = triangles_[side.triangle()];
  if (t.constrained[side.corner()]) return false;
  const Index p = tip_of(side), a = start_of(side), b = end_of(side), d = tip_of(mirror(side));
  if (p == kInfinite || a == kInfinite || b == kInfinite || d == kInfinite) return false;
  const auto position = CGAL::side_of_oriented_circle(place(points_[p]), place(points_[a]),
                                                      place(points_[b]), place(points_[d]));
  if (position != CGAL::ON_ORIENTED_BOUNDARY) return position == CGAL::ON_POSITIVE_SIDE;
  return std::max(a, b) > std::max(p, d);
}

/// The edge's start gets the other tip for its end, in its triangle, and its end the tip, in the
/// other one.
void ConstrainedDelaunay::flip(Side side) {
  const Side other = mirror(side);
  const Index p = tip_of(side), a = start_of(side), b = end_of(side), d = tip_of(other);
  const Side bp{side.triangle(), next(side.corner())}, ad{other.triangle(), next(other.corner())};
  const Side beyond_bp = mirror(bp), beyond_ad = mirror(ad);
  const bool is_bp = constrained(bp), is_ad = constrained(ad);
  triangles_[side.triangle()].corners[previous(side.corner())] = d;
  triangles_[other.triangle()].corners[previous(other.corner())] = p;
  link(side, beyond_ad, is_ad);
  link(other, beyond_bp, is_bp);
  link(bp, ad, false);
  triangle_at_[a] = side.triangle();
  triangle_at_[b] = other.triangle();
}

/// Of edges opposite a new point, and those that come to be so.
void ConstrainedDelaunay::flip_around(Index v) {
  if (on_line_) return;
  const Index start = triangle_at_[v];
  Index t = start;
  do {
    const std::uint32_t i = corner_of(t, v);
    to_check_.push_back({t, i});
    t = mirror({t, next(i)}).triangle();
  } while (t != start);
  while (!to_check_.empty()) {
    const Side side = to_check_.back();
    if (wants_flip(side)) {
      const Side other = mirror(side);
      flip(side);
      to_check_.push_back({other.triangle(), previous(other.corner())});
    } else {
      to_check_.pop_back();
    }
  }
}

void ConstrainedDelaunay::flip_all() {
  while (!to_check_.empty()) {
    const Side side = to_check_.back();
    to_check_.pop_back();
    if (!wants_flip(side)) continue;
    const Side other = mirror(side);
    flip(side);
    for (const Side s : {side, Side{side.triangle(), previous(side.corner())}, other,
                         Side{other.triangle(), previous(other.corner())}})
      to_check_.push_back(s);
  }
}

// Links.

void ConstrainedDelaunay::set(Index t, Index a, Index b, Index c) {
  triangles_[t].corners = {a, b, c};
  for (const Index v : {a, b, c}) (v == kInfinite ? infinite_ : triangle_at_[v]) = t;
}

ConstrainedDelaunay::Index ConstrainedDelaunay::add(Index a, Index b, Index c) {
  triangles_.emplace_back();
  const auto t = static_cast<Index>(triangles_.size() - 1);
  set(t, a, b, c);
  return t;
}

void ConstrainedDelaunay::link(Side s, Side t, bool is_constrained) {
  triangles_[s.triangle()].beyond[s.corner()] = t;
  triangles_[t.triangle()].beyond[t.corner()] = s;
  constrained(s) = constrained(t) = is_constrained;
}

std::uint32_t ConstrainedDelaunay::corner_of(Index t, Index v) const {
  const auto& corners = triangles_[t].corners;
  return corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
}

}  // namespace tensortopo
