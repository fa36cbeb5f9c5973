// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/embedded.hpp"

#include <algorithm>
#include <cstdint>
#include <atomic>
#include <mutex>

#include "mesh/exact_signs.hpp"
#include "run/parallel.hpp"
#include "surface/box_tree.hpp"

namespace certificate {
namespace {

using Point = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

/// An axis along which the triangle has an area; 3 if it has none.
std::size_t axis_of(const Point& a, const Point& b, const Point& c) {
  std::size_t axis = 0;
  while (axis < 3 && turn(a, b, c, axis) == 0) ++axis;
  return axis;
}

/// Do two segments of a plane meet? Ends count.
bool segments_meet(const Point& p, const Point& q, const Point& a, const Point& b,
                   std::size_t axis) {
  const int sa = turn(p, q, a, axis), sb = turn(p, q, b, axis);
  const int sp = turn(a, b, p, axis), sq = turn(a, b, q, axis);
  if (sa == 0 && sb == 0) {  // on one line
    for (std::size_t k = 0; k < 3; ++k)
      if (std::max(p[k], q[k]) < std::min(a[k], b[k]) || std::max(a[k], b[k]) < std::min(p[k], q[k]))
        return false;
    return true;
  }
  return sa * sb <= 0 && sp * sq <= 0;
}

bool is_inside(const Point& p, const Point& a, const Point& b, const Point& c, std::size_t axis) {
  const int s = turn(a, b, p, axis), t = turn(b, c, p, axis), u = turn(c, a, p, axis);
  return (s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0);
}

/// Do a segment and a triangle meet? Ends and edges count. @pre the triangle has an area
bool segment_meets(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c) {
  const int sp = side_of(a, b, c, p), sq = side_of(a, b, c, q);
  if (sp * sq > 0) return false;
  if (sp == 0 && sq == 0) {
    const std::size_t axis = axis_of(a, b, c);
    return is_inside(p, a, b, c, axis) || segments_meet(p, q, a, b, axis) ||
           segments_meet(p, q, b, c, axis) || segments_meet(p, q, c, a, axis);
  }
  const int s = side_of(p, q, a, b), t = side_of(p, q, b, c), u = side_of(p, q, c, a);
  return (s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0);
}

/// Do two triangles with an area meet elsewhere than in what they share?
class Pair {
 public:
  Pair(const std::vector<Point>& points, const Triangle& a, const Triangle& b)
      : points_(points), a_(a), b_(b) {
    for (std::size_t i = 0; i < 3; ++i)
      if (const auto at = std::find(b.begin(), b.end(), a[i]); at != b.end())
        shared_[count_++] = {i, static_cast<std::size_t>(at - b.begin())};
  }

  bool are_in_conflict() const {
    switch (count_) {
      case 0: return are_apart_by_planes() ? false : edges_meet();
      case 1: return opposite_edges_meet();
      case 2: return fold_together();
      default: return true;
    }
  }

 private:
  const Point& a(std::size_t i) const { return points_[a_[i % 3]]; }
  const Point& b(std::size_t i) const { return points_[b_[i % 3]]; }

  bool are_apart_by_planes() const {
    const int s = side_of(b(0), b(1), b(2), a(0));
    if (s != 0 && s == side_of(b(0), b(1), b(2), a(1)) && s == side_of(b(0), b(1), b(2), a(2)))
      return true;
    const int t = side_of(a(0), a(1), a(2), b(0));
    return t != 0 && t == side_of(a(0), a(1), a(2), b(1)) && t == side_of(a(0), a(1), a(2), b(2));
  }
  bool edges_meet() const {
    for (std::size_t i = 0; i < 3; ++i)
      if (segment_meets(a(i), a(i + 1), b(0), b(1), b(2)) ||
          segment_meets(b(i), b(i + 1), a(0), a(1), a(2)))
        return true;
    return false;
  }
  /// Where they meet beyond their common vertex they do along a segment from there, which ends where
  /// the first of the two ends: in the edge opposite the vertex.
  bool opposite_edges_meet() const {
    const auto [i, j] = shared_[0];
    return segment_meets(a(i + 1), a(i + 2), b(0), b(1), b(2)) ||
           segment_meets(b(j + 1), b(j + 2), a(0), a(1), a(2));
  }
  /// Two with a common edge overlap if they lie in one plane, on one side of the edge.
  bool fold_together() const {
    const std::size_t i = 3 - shared_[0][0] - shared_[1][0], j = 3 - shared_[0][1] - shared_[1][1];
    if (side_of(a(0), a(1), a(2), b(j)) != 0) return false;
    const std::size_t axis = axis_of(a(0), a(1), a(2));
    return turn(a(i + 1), a(i + 2), a(i), axis) == turn(a(i + 1), a(i + 2), b(j), axis);
  }

  const std::vector<Point>& points_;
  const Triangle &a_, &b_;
  std::array<std::array<std::size_t, 2>, 3> shared_{};
  std::size_t count_ = 0;
};

/// Pairs that are compared in all: triangles meet the boxes of some 30 others mostly.
constexpr std::uint64_t kLeast = 1000000, kPerTriangle = 100;

}  // namespace

EmbeddingResult find_conflict(const std::vector<Point>& points,
                              std::span<const Triangle> triangles) {
  std::vector<Box> boxes(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const std::uint32_t v : triangles[t]) boxes[t].add(points[v]);
  const BoxTree tree(std::move(boxes));
  std::mutex mutex;
  EmbeddingResult result{true, std::nullopt};
  const auto note = [&](std::size_t s, std::size_t t) {
    const std::lock_guard lock(mutex);
    if (!result.conflict || s < result.conflict->first ||
        (s == result.conflict->first && t < result.conflict->second))
      result.conflict = {s, t};
  };
  const auto corner = [&](std::size_t t, std::size_t i) -> const Point& {
    return points[triangles[t][i]];
  };
  std::vector<char> has_area(triangles.size());
  parallel_for(triangles.size(), [&](std::size_t t) {
    has_area[t] = axis_of(corner(t, 0), corner(t, 1), corner(t, 2)) < 3;
    if (!has_area[t]) note(t, t);
  });
  // In parts, after each of which is seen what is left to do: nothing once the first conflict is known.
  std::uint64_t left = kLeast + kPerTriangle * triangles.size();
  for (std::size_t first = 0; first < triangles.size();) {
    if (result.conflict && result.conflict->first < first) break;
    if (left == 0) {
      result.decided = false;
      break;
    }
    const std::size_t size = std::min(triangles.size() - first,
                                      std::clamp<std::size_t>(left / BoxTree::kMostParts, 1, 8192));
    std::atomic<std::uint64_t> pairs{0};
    parallel_for(size, [&](std::size_t i) {
      const std::size_t s = first + i;
      std::uint64_t compared = 0;
      const bool all = !has_area[s] || tree.for_meeting(s, [&](std::size_t t) {
        ++compared;
        if (has_area[t] && Pair(points, triangles[s], triangles[t]).are_in_conflict()) note(s, t);
      });
      pairs += compared;
      if (all) return;
      const std::lock_guard lock(mutex);
      result.decided = false;
    });
    left -= std::min<std::uint64_t>(left, pairs);
    first += size;
  }
  return result;
}

}  // namespace certificate
