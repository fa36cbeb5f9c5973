// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tensortopo {

/// A constrained Delaunay triangulation of the convex hull of points in the plane, built point by
/// point and segment by segment. All signs are exact.
///
/// It is a function of the numbered points and of the segments, whatever the order of insertion: no
/// corner that a triangle sees is inside of its circle, and of four corners on one empty circle the
/// diagonal avoids the one with the largest number. (As if each point were lifted a little more
/// than all points before it: the lifted triangulation is unique.)
///
/// The triangles cover a sphere: those outside the hull have the corner `kInfinite`. While all
/// points are on one line there are no others.
class ConstrainedDelaunay {
 public:
  using Point = std::array<double, 2>;
  using Index = std::uint32_t;

  static constexpr Index kInfinite = UINT32_MAX;  ///< the corner that has no place
  static constexpr Index kNone = UINT32_MAX;      ///< no triangle

  /// The edge of a triangle opposite a corner.
  class Side {
   public:
    constexpr Side() = default;
    constexpr Side(Index triangle, std::uint32_t corner) : code_(triangle << 2 | corner) {}
    constexpr Index triangle() const { return code_ >> 2; }
    constexpr std::uint32_t corner() const { return code_ & 3; }
    constexpr bool is_none() const { return code_ == UINT32_MAX; }
    constexpr bool operator==(const Side&) const = default;

   private:
    std::uint32_t code_ = UINT32_MAX;
  };

  struct Triangle {
    std::array<Index, 3> corners;     ///< counter-clockwise
    std::array<Side, 3> beyond;       ///< the edges opposite the corners, from the other side
    std::array<bool, 3> constrained;  ///< whether these edges are parts of segments
    std::int32_t depth;               ///< see `number_regions`
  };

  /// Inserts points, numbered in their order after those that are there. One on a constrained edge
  /// splits it into two.
  /// @return false if a coordinate is not finite or two points coincide; then it is of no more use
  bool insert(std::span<const Point> points);

  /// Makes the segment between two points a chain of constrained edges, through all points that are
  /// on it.
  /// @return false if it has more than points in common with a segment that is there; then it may
  ///         be constrained up to there
  bool constrain(Index from, Index to);

  /// Gives each triangle as its `depth` the least number of segments that separate it from the
  /// outside. It holds until something is inserted.
  void number_regions();

  /// A triangle that contains the place, on its boundary perhaps; outside the hull one with the
  /// corner `kInfinite`; `kNone` if there are less than two points. Places near the last are found
  /// fast.
  Index locate(const Point& at);

  /// Whether a point was inserted on a constrained edge.
  bool has_split_segments() const { return has_split_segments_; }

  std::span<const Point> points() const { return points_; }
  /// In no order.
  std::span<const Triangle> triangles() const { return triangles_; }

  static bool is_infinite(const Triangle& t) {
    return t.corners[0] == kInfinite || t.corners[1] == kInfinite || t.corners[2] == kInfinite;
  }

 private:
  enum class Where : char { face, edge, vertex, outside, beyond_line };
  struct Location {
    Where where;
    Side side;  ///< the edge; `beyond_line`: one between `kInfinite` and the end of the line
  };

  /// An edge on the border of the triangles that a segment crosses, and its end vertex.
  struct BorderEdge {
    Index vertex;
    Side inner;  ///< from inside
    Side outer;  ///< from outside
    bool constrained;
    bool is_inside;  ///< crossed triangles are on both sides
    Side attached;   ///< of the new triangle at it, if `is_inside`
  };
  /// What a new triangle is to be attached to: a side, or an edge of the border.
  struct Attachment {
    Side side;
    BorderEdge* border;
  };

  bool insert_vertex(Index v);
  Location find(const Point& at) const;
  Location find_on_line(const Point& at) const;
  Location find_among_all(const Point& at) const;
  void start_line(Index v);
  void prolong_line(Index v, Side end);
  void split_face(Index t, Index v);
  void split_edge(Side side, Index v);
  void join_to_hull(Index v, Side visible);

  int turn(Index a, Index b, const Point& c) const;
  int turn(Index a, Index b, Index c) const { return turn(a, b, points_[c]); }
  bool wants_flip(Side side) const;
  void flip(Side side);
  void flip_around(Index v);
  void flip_all();

  Side towards(Index from, Index to, bool& is_edge) const;
  Index collect_crossed(Index from, Index to, Side side);
  void open_channel();
  Side fill(Index first, std::span<BorderEdge> border, std::span<const Index> free);
  void attach(Side side, const Attachment& to, std::span<BorderEdge> border);

  void set(Index t, Index a, Index b, Index c);
  Index add(Index a, Index b, Index c);
  void link(Side s, Side t, bool constrained);
  Side mirror(Side side) const { return triangles_[side.triangle()].beyond[side.corner()]; }
  bool& constrained(Side side) { return triangles_[side.triangle()].constrained[side.corner()]; }
  /// The ends of the edge and the corner opposite it.
  Index start_of(Side side) const {
    return triangles_[side.triangle()].corners[next(side.corner())];
  }
  Index end_of(Side side) const {
    return triangles_[side.triangle()].corners[previous(side.corner())];
  }
  Index tip_of(Side side) const { return triangles_[side.triangle()].corners[side.corner()]; }
  std::uint32_t corner_of(Index t, Index v) const;
  static constexpr std::uint32_t next(std::uint32_t i) { return i == 2 ? 0 : i + 1; }
  static constexpr std::uint32_t previous(std::uint32_t i) { return i == 0 ? 2 : i - 1; }

  std::vector<Point> points_;
  std::vector<Index> triangle_at_;  ///< one of each point; `kNone` if it is not inserted
  std::vector<Triangle> triangles_;
  Index lone_ = kNone;      ///< the only point
  Index infinite_ = kNone;  ///< a triangle outside
  Index near_ = kNone;      ///< where to start looking
  bool on_line_ = true, has_split_segments_ = false;

  // Memory that is used again.
  std::vector<Side> to_check_;
  std::vector<BorderEdge> left_, right_;
  std::vector<Index> crossed_, stack_, beyond_;
  std::vector<std::pair<Index, Attachment>> chain_;
};

}  // namespace tensortopo
