// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/parts/plane_cases.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace tensortopo::test {

namespace {

using Index = ConstrainedDelaunay::Index;
using Point = ConstrainedDelaunay::Point;

std::int64_t x_of(const PlaneCase& c, std::size_t i) {
  return static_cast<std::int64_t>(c.points[i][0]);
}
std::int64_t y_of(const PlaneCase& c, std::size_t i) {
  return static_cast<std::int64_t>(c.points[i][1]);
}

/// Of a point of the case: also its ends.
bool is_on(const PlaneCase& c, std::size_t p, const PlaneCase::Segment& s) {
  const auto [a, b] = s;
  return exact_turn(c, a, b, p) == 0 && std::min(c.points[a], c.points[b]) <= c.points[p] &&
         c.points[p] <= std::max(c.points[a], c.points[b]);
}

std::set<std::pair<std::size_t, std::size_t>> pieces_of(const PlaneCase& c) {
  std::set<std::pair<std::size_t, std::size_t>> pieces;
  for (const auto& s : c.segments) {
    std::vector<std::size_t> on;
    for (std::size_t p = 0; p < c.points.size(); ++p)
      if (is_on(c, p, s)) on.push_back(p);
    std::sort(on.begin(), on.end(),
              [&](std::size_t p, std::size_t q) { return c.points[p] < c.points[q]; });
    for (std::size_t i = 0; i + 1 < on.size(); ++i) pieces.insert(std::minmax(on[i], on[i + 1]));
  }
  return pieces;
}

/// Twice the area of the convex hull.
std::int64_t hull_area(const PlaneCase& c) {
  std::vector<std::size_t> order(c.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::int64_t area = 0;
  for (int side = 0; side < 2; ++side) {
    std::sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) {
      return side == 0 ? c.points[p] < c.points[q] : c.points[q] < c.points[p];
    });
    std::vector<std::size_t> chain;
    for (const auto p : order) {
      while (chain.size() > 1 && exact_turn(c, chain[chain.size() - 2], chain.back(), p) <= 0)
        chain.pop_back();
      chain.push_back(p);
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      area += x_of(c, chain[i]) * y_of(c, chain[i + 1]) - x_of(c, chain[i + 1]) * y_of(c, chain[i]);
  }
  return area;
}

/// Whether a ray from the middle of a triangle meets an odd number of segments. (All is tripled.)
bool is_in_regions(const PlaneCase& c, const std::array<Index, 3>& t) {
  std::int64_t x = 0, y = 0;
  for (const Index v : t) x += x_of(c, v), y += y_of(c, v);
  bool odd = false;
  for (auto [a, b] : c.segments) {
    if (y_of(c, a) > y_of(c, b)) std::swap(a, b);
    if (3 * y_of(c, a) > y || 3 * y_of(c, b) <= y) continue;
    const auto side = (3 * x_of(c, b) - 3 * x_of(c, a)) * (y - 3 * y_of(c, a)) -
                      (3 * y_of(c, b) - 3 * y_of(c, a)) * (x - 3 * x_of(c, a));
    odd ^= side > 0;
  }
  return odd;
}

int integer(std::mt19937& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

void add_if_new(PlaneCase& c, const Point& p) {
  if (std::find(c.points.begin(), c.points.end(), p) == c.points.end()) c.points.push_back(p);
}

/// Around the middle, from one direction to the next; rounding may put points off their direction.
void add_outline(PlaneCase& c, int corners, double least, double most, std::mt19937& random) {
  const std::size_t first = c.points.size();
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283 * i / corners;
    const double radius = std::uniform_real_distribution<>(least, most)(random);
    add_if_new(c, {std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))});
  }
  const std::size_t end = c.points.size();
  for (std::size_t i = first; i < end; ++i) c.segments.push_back({i, i + 1 < end ? i + 1 : first});
}

bool is_allowed(const PlaneCase& c, const PlaneCase::Segment& s) {
  return s[0] != s[1] && std::none_of(c.segments.begin(), c.segments.end(),
                                      [&](const auto& t) { return are_in_conflict(c, s, t); });
}

PlaneCase outlines(std::mt19937& random) {
  PlaneCase c;
  add_outline(c, integer(random, 5, 60), 1000, 3000, random);
  if (integer(random, 0, 1) == 1) add_outline(c, integer(random, 3, 20), 300, 900, random);
  if (integer(random, 0, 2) == 0) add_outline(c, integer(random, 3, 12), 50, 200, random);
  for (int i = integer(random, 0, 50); i > 0; --i)
    add_if_new(c, {1.0 * integer(random, -3000, 3000), 1.0 * integer(random, -3000, 3000)});
  auto segments = std::move(c.segments);
  c.segments.clear();
  c.has_regions = true;
  for (const auto& s : segments) {
    if (is_allowed(c, s))
      c.segments.push_back(s);
    else
      c.has_regions = false;
  }
  return c;
}

PlaneCase lattice(bool starts_on_line, std::mt19937& random) {
  PlaneCase c;
  const int size = integer(random, 1, 9), count = integer(random, 2, 40);
  const int a = integer(random, -2, 2), b = integer(random, 1, 2);
  if (starts_on_line)
    for (int i = integer(random, 2, 12); i > 0; --i) {
      const int at = integer(random, -9, 9);
      add_if_new(c, {1.0 * a * at, 1.0 * b * at});
    }
  if (!starts_on_line || integer(random, 0, 3) > 0)
    for (int i = 0; i < count; ++i)
      add_if_new(c, {1.0 * integer(random, 0, size), 1.0 * integer(random, 0, size)});
  const int last = static_cast<int>(c.points.size()) - 1;
  for (int i = integer(random, 0, 30); i > 0; --i) {
    const PlaneCase::Segment s{static_cast<std::size_t>(integer(random, 0, last)),
                               static_cast<std::size_t>(integer(random, 0, last))};
    if (is_allowed(c, s)) c.segments.push_back(s);
  }
  return c;
}

}  // namespace

std::int64_t exact_turn(const PlaneCase& c, std::size_t p, std::size_t q, std::size_t r) {
  return (x_of(c, q) - x_of(c, p)) * (y_of(c, r) - y_of(c, p)) -
         (y_of(c, q) - y_of(c, p)) * (x_of(c, r) - x_of(c, p));
}

std::int64_t exact_in_circle(const PlaneCase& c, std::size_t p, std::size_t q, std::size_t r,
                             std::size_t s) {
  std::int64_t x[3], y[3], squared[3];
  const std::size_t corners[3] = {p, q, r};
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = x_of(c, corners[i]) - x_of(c, s);
    y[i] = y_of(c, corners[i]) - y_of(c, s);
    squared[i] = x[i] * x[i] + y[i] * y[i];
  }
  return squared[0] * (x[1] * y[2] - x[2] * y[1]) + squared[1] * (x[2] * y[0] - x[0] * y[2]) +
         squared[2] * (x[0] * y[1] - x[1] * y[0]);
}

bool are_in_conflict(const PlaneCase& c, const PlaneCase::Segment& s, const PlaneCase::Segment& t) {
  const auto sign = [](std::int64_t n) { return n > 0 ? 1 : n < 0 ? -1 : 0; };
  const auto sides = [&](const PlaneCase::Segment& line, const PlaneCase::Segment& ends) {
    return sign(exact_turn(c, line[0], line[1], ends[0])) *
           sign(exact_turn(c, line[0], line[1], ends[1]));
  };
  if (exact_turn(c, s[0], s[1], t[0]) == 0 && exact_turn(c, s[0], s[1], t[1]) == 0) {
    const auto low = [&](const auto& e) { return std::min(c.points[e[0]], c.points[e[1]]); };
    const auto high = [&](const auto& e) { return std::max(c.points[e[0]], c.points[e[1]]); };
    return std::max(low(s), low(t)) < std::min(high(s), high(t));
  }
  if (sides(s, t) >= 0 || sides(t, s) >= 0) return false;
  for (std::size_t p = 0; p < c.points.size(); ++p)
    if (is_on(c, p, s) && is_on(c, p, t)) return false;
  return true;
}

PlaneCase random_plane_case(std::mt19937& random) {
  switch (integer(random, 0, 2)) {
    case 0:
      return outlines(random);
    case 1:
      return lattice(false, random);
    default:
      return lattice(true, random);
  }
}

bool insert(const PlaneCase& c, ConstrainedDelaunay& triangulation) {
  return triangulation.insert(c.points) &&
         std::all_of(c.segments.begin(), c.segments.end(), [&](const auto& s) {
           return triangulation.constrain(static_cast<Index>(s[0]), static_cast<Index>(s[1]));
         });
}

std::string flaws_of(const PlaneCase& c, const ConstrainedDelaunay& triangulation) {
  const auto triangles = triangulation.triangles();
  const auto pieces = pieces_of(c);
  std::set<std::pair<std::size_t, std::size_t>> constrained;
  std::int64_t area = 0;
  std::set<Index> corners;
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto& triangle = triangles[t];
    const auto& v = triangle.corners;
    const bool is_infinite = ConstrainedDelaunay::is_infinite(triangle);
    corners.insert(v.begin(), v.end());
    if (!is_infinite) {
      const auto part = exact_turn(c, v[0], v[1], v[2]);
      if (part <= 0) return "a triangle is not counter-clockwise";
      area += part;
    }
    if (is_infinite && triangle.depth != 0) return "the outside has another depth than 0";
    if (!is_infinite && c.has_regions && (triangle.depth % 2 != 0) != is_in_regions(c, v))
      return "a triangle is in no region but numbered as in one, or the other way round";
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto beyond = triangle.beyond[i];
      const auto& other = triangles[beyond.triangle()];
      const std::uint32_t j = beyond.corner();
      const Index a = v[(i + 1) % 3], b = v[(i + 2) % 3], p = v[i], d = other.corners[j];
      if (other.beyond[j] != ConstrainedDelaunay::Side(t, i) || other.corners[(j + 1) % 3] != b ||
          other.corners[(j + 2) % 3] != a || other.constrained[j] != triangle.constrained[i])
        return "neighbours do not fit";
      if (triangle.constrained[i]) constrained.insert(std::minmax<std::size_t>(a, b));
      if (triangle.constrained[i] || is_infinite || d == ConstrainedDelaunay::kInfinite) continue;
      const auto inside = exact_in_circle(c, p, a, b, d);
      if (inside > 0) return "a corner is inside a circle";
      if (inside == 0 && std::max(a, b) > std::max(p, d)) return "the diagonal is the other one";
    }
  }
  corners.erase(ConstrainedDelaunay::kInfinite);
  if (c.points.size() > 1 && corners.size() != c.points.size()) return "a point is no corner";
  if (area != hull_area(c)) return "the areas do not add up";
  if (constrained != pieces) return "other edges are constrained than those on segments";
  return "";
}

std::vector<std::array<Index, 3>> finite_triangles(const ConstrainedDelaunay& triangulation) {
  std::vector<std::array<Index, 3>> result;
  for (const auto& t : triangulation.triangles()) {
    if (ConstrainedDelaunay::is_infinite(t)) continue;
    auto corners = t.corners;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.push_back(corners);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace tensortopo::test
