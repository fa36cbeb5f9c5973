// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "extract/level/level.hpp"
#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo::detail {

using Place = Vector3<double>;

/// Points of triangles, so many that each point of the triangles is within a distance of one of
/// them.
class TrianglePoints {
 public:
  /// @param most  more are not kept
  TrianglePoints(double distance, std::size_t most)
      : from_corner_(0.25 * distance), side_(0.57 * 0.75 * distance), most_(most) {}

  /// False if there would be too many.
  ///
  /// The corners of the triangle are taken, and the middles of its edges again and again until all
  /// points are within a quarter of the distance of one of them (every point of a triangle is
  /// within 1 / sqrt(3) of its longest edge from a corner); of these the first in each cube of a
  /// grid with diagonals of the other three quarters.
  bool add(const std::array<Place, 3>& triangle) {
    constexpr double kFarthest = 0.58;
    constexpr std::size_t kMostParts = 200000;
    const auto& [a, b, c] = triangle;
    if (points_.size() > most_ || ++parts_ > kMostParts) return false;
    if (kFarthest * std::max({length(b - a), length(c - b), length(a - c)}) <= from_corner_) {
      for (const Place& p : triangle) keep(p);
      return true;
    }
    const Place d = 0.5 * (b + c), e = 0.5 * (c + a), f = 0.5 * (a + b);
    const std::array<std::array<Place, 3>, 4> parts{{{d, e, f}, {a, f, e}, {b, d, f}, {c, e, d}}};
    return std::all_of(parts.begin(), parts.end(), [&](const auto& part) { return add(part); });
  }
  const std::vector<Place>& points() const { return points_; }

 private:
  void keep(const Place& p) {
    if (cubes_.insert({std::floor(p.x / side_), std::floor(p.y / side_), std::floor(p.z / side_)})
            .second)
      points_.push_back(p);
  }

  double from_corner_, side_;
  std::size_t most_, parts_ = 0;
  std::set<std::array<double, 3>> cubes_;
  std::vector<Place> points_;
};

/// A tetrahedron, cut at the middles of longest edges as far as somebody asks.
template <class Cell>
class CellParts {
 public:
  /// @param cell        says by `is_on_side` of weights on which side of the level a simplex is
  /// @param most_parts  more are not made
  CellParts(const Cell& cell, const std::array<Place, 4>& vertices, std::size_t most_parts)
      : cell_(cell), most_parts_(most_parts) {
    std::array<std::uint32_t, 4> corners{};
    for (std::uint32_t i = 0; i < 4; ++i) {
      Weights weights{};
      weights[i] = 1;
      corners[i] = add_corner(weights, vertices[i]);
    }
    parts_.push_back(part_of(corners));
  }

  /// Whether the level is proved to be within a distance of a point: two corners of parts are that
  /// near to it, on different sides.
  bool is_near(const Place& point, double distance) {
    constexpr std::size_t kMostAsked = 4000;
    bool is_below = false, is_above = false;
    std::vector<std::uint32_t> waiting{0};  // the largest parts first
    for (std::size_t i = 0; i < waiting.size() && i < kMostAsked && !is_too_much(1); ++i) {
      const Part part = parts_[waiting[i]];
      if (length(part.middle - point) > distance + part.radius) continue;
      for (const auto c : part.corners) {
        if (length(corners_[c].place - point) > distance) continue;
        is_above = is_above || corners_[c].side == Verdict::positive;
        is_below = is_below || corners_[c].side == Verdict::negative;
      }
      if (is_above && is_below) return true;
      if (!is_clear(waiting[i]) && split(waiting[i]))
        waiting.insert(waiting.end(), {parts_[waiting[i]].half, parts_[waiting[i]].half + 1});
    }
    return false;
  }

  /// Whether each point of the level is proved to be within a distance of one of some points: each
  /// part is clear of the level, or its corners are all that near to one of these (then all of it
  /// is, as balls are convex).
  bool is_covered(const std::vector<Place>& points, double distance) {
    struct Waiting {
      std::uint32_t part;
      std::vector<Place> around;  ///< of the points those that may be that near to it
    };
    std::vector<Waiting> waiting;
    waiting.push_back({0, points});
    while (!waiting.empty()) {
      auto [p, around] = std::move(waiting.back());
      waiting.pop_back();
      if (is_too_much(1 + around.size())) return false;
      const Part part = parts_[p];
      const auto from_middle = [&](const Place& x) { return length(x - part.middle); };
      std::erase_if(around,
                    [&](const Place& x) { return from_middle(x) > distance + part.radius; });
      const auto nearest = std::min_element(
          around.begin(), around.end(),
          [&](const Place& x, const Place& y) { return from_middle(x) < from_middle(y); });
      if (nearest != around.end() &&
          std::all_of(part.corners.begin(), part.corners.end(), [&](std::uint32_t c) {
            return length(corners_[c].place - *nearest) <= distance;
          }))
        continue;
      if (is_clear(p)) continue;
      if (!split(p)) return false;
      waiting.push_back({parts_[p].half, around});
      waiting.push_back({parts_[p].half + 1, std::move(around)});
    }
    return true;
  }

 private:
  using Weights = std::array<double, 4>;
  struct Corner {
    Weights weights;
    Place place;
    Verdict side = Verdict::unknown;
  };
  enum class Clear : std::uint8_t { unknown, yes, no };
  struct Part {
    std::array<std::uint32_t, 4> corners{};
    Place middle{};
    double radius = 0;       ///< of all corners around it
    std::uint32_t half = 0;  ///< the first of two; 0: not cut
    Clear clear = Clear::unknown;
  };

  std::uint32_t add_corner(const Weights& weights, const Place& place) {
    const std::array<Weights, 1> point{weights};
    Verdict side = Verdict::unknown;
    for (const Verdict one : {Verdict::positive, Verdict::negative})
      if (cell_.is_on_side(point, one)) side = one;
    corners_.push_back({weights, place, side});
    return static_cast<std::uint32_t>(corners_.size() - 1);
  }

  Part part_of(const std::array<std::uint32_t, 4>& corners) const {
    Part part{corners};
    for (const auto c : corners) part.middle += 0.25 * corners_[c].place;
    for (const auto c : corners)
      part.radius = std::max(part.radius, length(corners_[c].place - part.middle));
    return part;
  }

  bool is_clear(std::uint32_t p) {
    Part& part = parts_[p];
    if (part.clear == Clear::unknown) {
      std::array<Weights, 4> weights;
      for (std::size_t i = 0; i < 4; ++i) weights[i] = corners_[part.corners[i]].weights;
      const Verdict side = corners_[part.corners[0]].side;
      part.clear =
          side != Verdict::unknown && cell_.is_on_side(weights, side) ? Clear::yes : Clear::no;
    }
    return part.clear == Clear::yes;
  }

  /// Counts parts, and points beside them, that are looked at.
  bool is_too_much(std::size_t more) {
    constexpr std::size_t kMost = 4000000;
    return (looked_at_ += more) > kMost;
  }

  /// False if there are too many parts.
  bool split(std::uint32_t p) {
    if (parts_[p].half != 0) return true;
    if (parts_.size() + 2 > most_parts_) return false;
    const auto corners = parts_[p].corners;
    std::size_t first = 0, last = 1;
    double longest = -1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (const double size = length(corners_[corners[j]].place - corners_[corners[i]].place);
            size > longest)
          longest = size, first = i, last = j;
    const Corner a = corners_[corners[first]], b = corners_[corners[last]];
    Weights weights;
    for (std::size_t k = 0; k < 4; ++k) weights[k] = 0.5 * (a.weights[k] + b.weights[k]);
    const std::uint32_t middle = add_corner(weights, 0.5 * (a.place + b.place));
    parts_[p].half = static_cast<std::uint32_t>(parts_.size());
    for (const std::size_t replaced : {first, last}) {
      auto half = corners;
      half[replaced] = middle;
      parts_.push_back(part_of(half));
    }
    return true;
  }

  const Cell& cell_;
  std::size_t most_parts_;
  std::vector<Corner> corners_;
  std::vector<Part> parts_;
  std::size_t looked_at_ = 0;
};

}  // namespace tensortopo::detail
