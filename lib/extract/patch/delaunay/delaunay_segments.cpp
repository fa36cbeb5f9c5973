// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0

// Segments of constrained Delaunay triangulations.

#include <algorithm>
#include <utility>

#include "extract/patch/delaunay/constrained_delaunay.hpp"
#include "extract/run/assert.hpp"

namespace tensortopo {

bool ConstrainedDelaunay::constrain(Index from, Index to) {
  while (from != to) {
    bool is_edge = false;
    const Side side = towards(from, to, is_edge);
    if (is_edge) {
      if (constrained(side)) return false;
      from = end_of(side);
      link(side, mirror(side), true);
      continue;
    }
    const Index end = collect_crossed(from, to, side);
    if (end == kNone) return false;
    open_channel();
    const std::span<const Index> free(crossed_);
    const std::size_t on_left = left_.size() - 1;
    const Side left = fill(from, left_, free.first(on_left));
    // The other way round it is on the left as well.
    Index start = from;
    for (auto& edge : right_) std::swap(edge.vertex, start);
    std::reverse(right_.begin(), right_.end());
    const Side right = fill(end, right_, free.subspan(on_left));
    link(left, right, true);
    for (const Index t : crossed_)
      for (std::uint32_t i = 0; i < 3; ++i) to_check_.push_back({t, i});
    flip_all();
    from = end;
  }
  return true;
}

void ConstrainedDelaunay::number_regions() {
  constexpr std::int32_t unknown = -1;
  for (auto& t : triangles_) t.depth = unknown;
  stack_.clear();
  if (!triangles_.empty()) stack_.push_back(infinite_);
  for (std::int32_t depth = 0; !stack_.empty(); ++depth) {
    beyond_.clear();
    while (!stack_.empty()) {
      Triangle& t = triangles_[stack_.back()];
      stack_.pop_back();
      if (t.depth != unknown) continue;
      t.depth = depth;
      for (std::size_t i = 0; i < 3; ++i)
        if (const Index u = t.beyond[i].triangle(); triangles_[u].depth == unknown)
          (t.constrained[i] ? beyond_ : stack_).push_back(u);
    }
    stack_.swap(beyond_);
  }
}

/// The edge that leads from one point towards another, with the point as its start, or the edge
/// across which one leaves the triangles around the point.
ConstrainedDelaunay::Side ConstrainedDelaunay::towards(Index from, Index to, bool& is_edge) const {
  const Index start = triangle_at_[from];
  is_edge = true;
  Index t = start;
  do {
    const std::uint32_t i = corner_of(t, from);
    if (triangles_[t].corners[next(i)] == to) return {t, previous(i)};
    t = mirror({t, next(i)}).triangle();
  } while (t != start);

  const bool is_up = points_[from] < points_[to];
  do {
    const std::uint32_t i = corner_of(t, from);
    const Index r = triangles_[t].corners[next(i)], l = triangles_[t].corners[previous(i)];
    if (r != kInfinite) {
      const int side = turn(from, to, r);
      if (side == 0 && (points_[from] < points_[r]) == is_up) return {t, previous(i)};
      if (side < 0 && l != kInfinite && turn(from, to, l) > 0) {
        is_edge = false;
        return {t, i};
      }
    }
    t = mirror({t, next(i)}).triangle();
  } while (t != start);
  TENSORTOPO_ASSERT(false, "triangles surround each point");
  return {};
}

/// The triangles that the segment crosses behind the edge, up to the next point on it, and what is
/// on the left and the right of them.
/// @return that point; `kNone` if it would cross a constrained edge
ConstrainedDelaunay::Index ConstrainedDelaunay::collect_crossed(Index from, Index to, Side side) {
  crossed_.assign(1, side.triangle());
  const auto edge = [&](Index end, Index t, std::uint32_t corner) {
    return BorderEdge{end, {t, corner}, mirror({t, corner}), constrained({t, corner}), false, {}};
  };
  left_.assign(1, edge(end_of(side), side.triangle(), next(side.corner())));
  right_.assign(1, edge(start_of(side), side.triangle(), previous(side.corner())));
  for (;;) {
    if (constrained(side)) return kNone;
    const Side other = mirror(side);
    const Index t = other.triangle(), d = tip_of(other);
    const std::uint32_t i = other.corner();
    crossed_.push_back(t);
    const int at = d == to ? 0 : turn(from, to, d);
    if (at >= 0) left_.push_back(edge(d, t, previous(i)));
    if (at <= 0) right_.push_back(edge(d, t, next(i)));
    if (at == 0) return d;
    side = {t, at > 0 ? next(i) : previous(i)};
  }
}

/// Finds the edges that have crossed triangles on both sides.
void ConstrainedDelaunay::open_channel() {
  constexpr std::int32_t crossed = -1;
  for (const Index t : crossed_) triangles_[t].depth = crossed;
  for (auto* border : {&left_, &right_})
    for (auto& edge : *border) edge.is_inside = triangles_[edge.outer.triangle()].depth == crossed;
  for (const Index t : crossed_) triangles_[t].depth = 0;
}

/// Triangulates what is between a border and the line that joins its ends, on the right of the
/// border: it cuts off corners that turn to the right. Each corner was joined to points beyond the
/// line: all are seen from there, and so each triangle that is cut off is empty.
/// @return the side at the line
ConstrainedDelaunay::Side ConstrainedDelaunay::fill(Index first, std::span<BorderEdge> border,
                                                    std::span<const Index> free) {
  chain_.assign(1, {first, {{}, nullptr}});
  std::size_t used = 0;
  for (auto& edge : border) {
    Attachment behind{edge.outer, &edge};
    while (chain_.size() > 1) {
      const auto [middle, before] = chain_.back();
      const Index start = chain_[chain_.size() - 2].first;
      if (turn(start, middle, edge.vertex) >= 0) break;
      const Index t = free[used++];
      set(t, start, edge.vertex, middle);
      attach({t, 0}, behind, border);
      attach({t, 1}, before, border);
      behind = {{t, 2}, nullptr};
      chain_.pop_back();
    }
    chain_.emplace_back(edge.vertex, behind);
  }
  TENSORTOPO_ASSERT(chain_.size() == 2 && used == free.size(), "a channel is filled");
  return chain_.back().second.side;
}

void ConstrainedDelaunay::attach(Side side, const Attachment& to, std::span<BorderEdge> border) {
  if (to.border == nullptr) return link(side, to.side, false);
  if (!to.border->is_inside) return link(side, to.side, to.border->constrained);
  to.border->attached = side;
  const auto partner = std::find_if(border.begin(), border.end(), [&](const BorderEdge& edge) {
    return edge.inner == to.border->outer;
  });
  TENSORTOPO_ASSERT(partner != border.end(), "an edge inside has two sides");
  if (!partner->attached.is_none()) link(side, partner->attached, to.border->constrained);
}

}  // namespace tensortopo
