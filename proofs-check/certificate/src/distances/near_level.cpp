// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distances/near_level.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "distances/weighted_tensors.hpp"

namespace certificate {
namespace {

/// Places are sums of four products of doubles, or come of at most 30 halvings: each adds 2^-53.
constexpr double kPlaceError = 0x1p-47;
/// Lengths are computed from those with some roundings.
constexpr double kLengthError = 0x1p-48;
constexpr std::size_t kMostPoints = 40000, kMostParts = 200000, kMostAsked = 8000;
/// In one tetrahedron, of parts and points that are looked at: four times what extraction does at
/// most.
constexpr std::size_t kMostWork = 16000000;
constexpr int kMostHalvings = 30;

/// Distances are not compared with less, nor coordinates larger than that looked at: squares of
/// smaller lengths are not exact enough, those of larger ones not finite.
constexpr double kLeastDistance = 0x1p-400, kLargestCoordinate = 0x1p500;

double length_between(const Point3& x, const Point3& y) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) square += (x[k] - y[k]) * (x[k] - y[k]);
  return std::sqrt(square);
}

Point3 middle_of(const Point3& x, const Point3& y) {
  return {x[0] / 2 + y[0] / 2, x[1] / 2 + y[1] / 2, x[2] / 2 + y[2] / 2};
}

/// Points of triangles of which one is within a distance of each other point. Of corners of parts
/// of triangles, which are within a quarter of it from the points of their part, one in each cube
/// of a grid, which is within the other three quarters of the others there.
class SpreadPoints {
 public:
  explicit SpreadPoints(double distance) : distance_(distance) {}

  /// False if there are too many.
  bool add(const std::array<Point3, 3>& triangle) { return add(triangle, kMostHalvings); }
  void add_point(const Point3& x) {
    if (cubes_.insert(cube_of(x)).second) points_.push_back(x);
  }
  const std::vector<Point3>& points() const { return points_; }
  /// How many parts were looked at.
  std::size_t work() const { return work_; }

 private:
  /// Each point of a part is within a length of a corner if its edges are shorter than sqrt(3)
  /// times that length (the circle around an acute triangle has at most that radius; else the
  /// sides' middles are still nearer).
  bool add(const std::array<Point3, 3>& t, int halvings) {
    if (++work_ > kMostWork || points_.size() > kMostPoints) return false;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, length_between(t[k], t[(k + 1) % 3]));
    if (longest < 1.73 / 4 * distance_) {
      for (const Point3& corner : t) add_point(corner);
      return true;
    }
    if (halvings == 0) return false;
    const std::array<Point3, 3> m{middle_of(t[1], t[2]), middle_of(t[2], t[0]),
                                  middle_of(t[0], t[1])};
    return add(m, halvings - 1) && add({t[0], m[2], m[1]}, halvings - 1) &&
           add({t[1], m[0], m[2]}, halvings - 1) && add({t[2], m[1], m[0]}, halvings - 1);
  }
  Point3 cube_of(const Point3& x) const {
    const double side = 0.75 / 1.74 * distance_;
    return {std::floor(x[0] / side), std::floor(x[1] / side), std::floor(x[2] / side)};
  }

  double distance_;
  std::vector<Point3> points_;
  std::set<Point3> cubes_;
  std::size_t work_ = 0;
};

/// A tetrahedron and its parts, cut at the middles of their longest edges when they are asked for.
class Parts {
 public:
  Parts(const LevelCase& c, std::size_t tet) : c_(c), tensors_(c.field) {
    const auto& v = c.input.tets[tet];
    std::copy(v.begin(), v.end(), whole_.corners.begin());
    whole_.count = 4;
    Part part;
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<double, 4> weights{};
      weights[i] = 1;
      part.corners[i] = add_corner(weights);
    }
    add_part(part);
  }

  /// How many parts were looked at.
  std::size_t work() const { return work_; }

  bool has_level_near(const Point3& x, double distance) {
    bool above = false, below = false;
    std::vector<std::size_t> asked{0};
    for (std::size_t i = 0; i < std::min(asked.size(), kMostAsked) && !(above && below); ++i) {
      if (work_ > kMostWork) return false;
      const Part part = parts_[asked[i]];
      ++work_;
      if (length_between(part.middle, x) > distance + 1.01 * part.radius) continue;
      for (const auto corner : part.corners)
        if (length_between(corners_[corner].place, x) <= distance)
          (corners_[corner].above ? above : below) = true;
      if (is_clear(asked[i]) || !cut(asked[i])) continue;
      asked.push_back(parts_[asked[i]].first);
      asked.push_back(parts_[asked[i]].first + 1);
    }
    return above && below;
  }

  /// Is all of the tetrahedron that is not farther clear of the level?
  bool has_no_level_within(const Point3& x, double distance) {
    std::vector<std::size_t> asked{0};
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const Part part = parts_[asked[i]];
      ++work_;
      if (length_between(part.middle, x) > distance + 1.01 * part.radius || is_clear(asked[i]))
        continue;
      if (i >= kMostAsked || !cut(asked[i])) return false;
      asked.push_back(parts_[asked[i]].first);
      asked.push_back(parts_[asked[i]].first + 1);
    }
    return true;
  }

  bool are_near_or_clear(const std::vector<Point3>& points, double distance) {
    // Parts, and of the points those that may be near to them.
    std::vector<std::pair<std::size_t, std::vector<Point3>>> asked;
    asked.emplace_back(0, points);
    while (!asked.empty()) {
      auto [p, around] = std::move(asked.back());
      asked.pop_back();
      if ((work_ += 1 + around.size()) > kMostWork) return false;
      const double most = distance + 1.01 * parts_[p].radius;
      std::erase_if(around,
                    [&](const Point3& x) { return length_between(parts_[p].middle, x) > most; });
      if (is_near_one(parts_[p], around, distance) || is_clear(p)) continue;
      if (!cut(p)) return false;
      asked.emplace_back(parts_[p].first, around);
      asked.emplace_back(parts_[p].first + 1, std::move(around));
    }
    return true;
  }

 private:
  /// With the number that its tensor has.
  struct PartCorner {
    Point3 place;
    bool above;
  };
  enum class Clear : std::uint8_t { not_asked, yes, no };
  struct Part {
    std::array<std::uint32_t, 4> corners{};
    Point3 middle{};
    double radius = 0;      ///< about it
    std::size_t first = 0;  ///< of its two parts; 0: it is not cut
    int cuts = 0;           ///< that it came of
    Clear clear = Clear::not_asked;
  };

  /// Weights are halves of halves, as many as 52 bits hold, so they are exact and add up to one.
  std::uint32_t add_corner(const std::array<double, 4>& weights) {
    Point3 place{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        place[k] += weights[i] * c_.input.points[whole_.corners[i]][k];
    const std::uint32_t id = tensors_.add(whole_, weights);
    corners_.push_back({place, c_.level.above(tensors_.corner(id, false))});
    return id;
  }

  void add_part(Part part) {
    part.middle = {};
    for (const auto corner : part.corners)
      for (std::size_t k = 0; k < 3; ++k) part.middle[k] += corners_[corner].place[k] / 4;
    part.radius = 0;
    for (const auto corner : part.corners)
      part.radius = std::max(part.radius, length_between(part.middle, corners_[corner].place));
    part.first = 0;
    part.clear = Clear::not_asked;
    parts_.push_back(part);
  }

  bool is_near_one(const Part& part, const std::vector<Point3>& points, double distance) const {
    const auto square = [&](const Point3& x) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += (x[k] - part.middle[k]) * (x[k] - part.middle[k]);
      return sum;
    };
    const auto nearest =
        std::min_element(points.begin(), points.end(),
                         [&](const Point3& x, const Point3& y) { return square(x) < square(y); });
    return nearest != points.end() &&
           std::all_of(part.corners.begin(), part.corners.end(), [&](std::uint32_t corner) {
             return length_between(corners_[corner].place, *nearest) <= distance;
           });
  }

  bool is_clear(std::size_t p) {
    Part& part = parts_[p];
    if (part.clear != Clear::not_asked) return part.clear == Clear::yes;
    std::array<Corner, 4> corners;
    bool alike = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool above = corners_[part.corners[i]].above;
      corners[i] = tensors_.corner(part.corners[i], above);
      alike = alike && above == corners_[part.corners[0]].above;
    }
    part.clear = alike && c_.level.is_one_sided(corners) ? Clear::yes : Clear::no;
    return part.clear == Clear::yes;
  }

  bool cut(std::size_t p) {
    if (parts_[p].first != 0) return true;
    const Part part = parts_[p];
    // Each cut halves one weight once more at most.
    if (parts_.size() >= kMostParts || part.cuts == 50) return false;
    std::array<std::size_t, 2> longest{0, 1};
    for_subsets(4, 2, [&](const auto& ends) {
      const auto of = [&](std::size_t i, std::size_t j) {
        return length_between(corners_[part.corners[i]].place, corners_[part.corners[j]].place);
      };
      if (of(ends[0], ends[1]) > of(longest[0], longest[1])) longest = {ends[0], ends[1]};
    });
    std::array<double, 4> weights;
    for (std::size_t k = 0; k < 4; ++k)
      weights[k] = tensors_.weights(part.corners[longest[0]])[k] / 2 +
                   tensors_.weights(part.corners[longest[1]])[k] / 2;
    const std::uint32_t middle = add_corner(weights);
    parts_[p].first = parts_.size();
    for (const std::size_t end : longest) {
      Part half = part;
      half.corners[end] = middle;
      ++half.cuts;
      add_part(half);
    }
    return true;
  }

  const LevelCase& c_;
  Carrier whole_;
  WeightedTensors tensors_;
  std::vector<PartCorner> corners_;
  std::vector<Part> parts_;
  std::size_t work_ = 0;
};

/// What rounding of places may add to a distance in a tetrahedron.
double place_error(const LevelCase& c, std::size_t tet) {
  double error = 0x1p-1000;
  for (std::size_t k = 0; k < 3; ++k) {
    double largest = 0;
    for (const Vertex v : c.input.tets[tet])
      largest = std::max(largest, std::abs(c.input.points[v][k]));
    error += kPlaceError * largest;
  }
  return error;
}

/// Whether lengths between places in a tetrahedron, corners of triangles among them, can be
/// compared with a distance.
bool are_comparable(const LevelCase& c, std::size_t tet,
                    const std::vector<std::array<Point3, 3>>& triangles, double distance) {
  const auto is_small = [](const Point3& x) {
    return std::all_of(x.begin(), x.end(),
                       [](double value) { return std::abs(value) <= kLargestCoordinate; });
  };
  const auto& v = c.input.tets[tet];
  return distance > kLeastDistance && distance <= kLargestCoordinate &&
         std::all_of(v.begin(), v.end(), [&](Vertex i) { return is_small(c.input.points[i]); }) &&
         std::all_of(triangles.begin(), triangles.end(),
                     [&](const auto& t) { return std::all_of(t.begin(), t.end(), is_small); });
}

}  // namespace

bool is_near_level(const LevelCase& c, std::size_t tet,
                   const std::vector<std::array<Point3, 3>>& triangles, double distance,
                   std::size_t& work) {
  const double rest = (distance - place_error(c, tet)) * (1 - kLengthError);
  if (!are_comparable(c, tet, triangles, rest)) return false;
  SpreadPoints spread(rest / 2);
  const bool are_few = std::all_of(triangles.begin(), triangles.end(),
                                   [&](const auto& triangle) { return spread.add(triangle); });
  work += spread.work();
  if (!are_few) return false;
  Parts parts(c, tet);
  const bool is_near =
      std::all_of(spread.points().begin(), spread.points().end(),
                  [&](const Point3& x) { return parts.has_level_near(x, rest / 2); }) &&
      parts.are_near_or_clear(spread.points(), rest);
  work += parts.work();
  return is_near;
}

std::optional<Point3> point_far_from_level(const LevelCase& c, std::size_t tet,
                                           const std::vector<std::array<Point3, 3>>& triangles,
                                           double distance) {
  const double most = (distance + place_error(c, tet)) * (1 + kLengthError);
  if (!are_comparable(c, tet, triangles, most)) return std::nullopt;
  SpreadPoints spread(most / 4);
  for (const auto& t : triangles) {
    const std::array<Point3, 3> m{middle_of(t[1], t[2]), middle_of(t[2], t[0]),
                                  middle_of(t[0], t[1])};
    for (const Point3& x : {middle_of(m[0], t[0]), m[0], m[1], m[2], t[0], t[1], t[2]})
      spread.add_point(x);
  }
  Parts parts(c, tet);
  for (const Point3& x : spread.points()) {
    if (parts.has_no_level_within(x, most)) return x;
    if (parts.work() > kMostWork) break;
  }
  return std::nullopt;
}

}  // namespace certificate
