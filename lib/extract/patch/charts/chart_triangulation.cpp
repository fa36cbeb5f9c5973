// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/chart_triangulation.hpp"

#include <algorithm>
#include <cmath>

#include "tensortopo/scalar/power_of_two.hpp"
#include "extract/patch/delaunay/constrained_delaunay.hpp"

namespace tensortopo {

namespace {

using ChartPoint = ChartTriangulation::Point;
using Index = ConstrainedDelaunay::Index;

bool is_inside(const ConstrainedDelaunay::Triangle& t) { return t.depth % 2 == 1; }

ChartPoint minus(const ChartPoint& a, const ChartPoint& b) { return {a[0] - b[0], a[1] - b[1]}; }
double product(const ChartPoint& a, const ChartPoint& b) { return a[0] * b[0] + a[1] * b[1]; }
double determinant(const ChartPoint& a, const ChartPoint& b) { return a[0] * b[1] - b[0] * a[1]; }

/// A vector times a power of two, with its largest coordinate near 1: radii of a chart reach from 1
/// to 1e260, and no square of theirs overflows or is lost.
struct ScaledVector {
  ChartPoint vector;
  int exponent = 0;  ///< of the power of two that takes it back

  explicit ScaledVector(const ChartPoint& d) : vector(d) {
    const double size = std::max(std::abs(d[0]), std::abs(d[1]));
    if (!(size > 0) || !std::isfinite(size)) return;
    exponent = floor_log2(size);
    for (double& x : vector) x = times_power(x, -exponent);
  }
};

/// The distance of two points, times the root of a factor.
double distance(const ChartPoint& a, const ChartPoint& b, double factor = 1) {
  const ScaledVector d(minus(b, a));
  return times_power(std::sqrt(factor * product(d.vector, d.vector)), d.exponent);
}

/// The distance of a point from the segment between two others, times the root of a factor.
double distance(const ChartPoint& at, const ChartPoint& a, const ChartPoint& b, double factor) {
  const ScaledVector along(minus(b, a)), to(minus(at, a));
  const double projected =
      times_power(product(to.vector, along.vector), to.exponent - along.exponent);
  const double length = product(along.vector, along.vector);
  if (projected <= 0) return distance(at, a, factor);
  if (projected > length) return distance(at, b, factor);
  const double area = determinant(along.vector, to.vector);
  return times_power(std::sqrt(factor * (area * area / length)), to.exponent);
}

ChartPoint circumcentre(const ChartPoint& a, const ChartPoint& b, const ChartPoint& c) {
  const ChartPoint q = minus(b, a), r = minus(c, a);
  const double r2 = product(r, r), q2 = product(q, q), twice = 2 * determinant(q, r);
  return {(r[1] * q2 - r2 * q[1]) / twice + a[0], -(r[0] * q2 - r2 * q[0]) / twice + a[1]};
}

/// The place of the corner with the smallest number.
std::size_t least_corner(const ConstrainedDelaunay::Triangle& t) {
  return static_cast<std::size_t>(std::min_element(t.corners.begin(), t.corners.end()) -
                                  t.corners.begin());
}

/// A triangulation and the corners of its triangles inside the regions.
class Regions {
 public:
  /// False if segments cross or cover each other, or points coincide.
  bool insert(const std::vector<ChartPoint>& points,
              const std::vector<std::array<std::size_t, 2>>& segments) {
    if (!triangulation_.insert(points)) return false;
    for (const auto& [a, b] : segments)
      if (!triangulation_.constrain(static_cast<Index>(a), static_cast<Index>(b))) return false;
    triangulation_.number_regions();
    return true;
  }

  /// False if points coincide or are on a segment.
  bool insert(const std::vector<ChartPoint>& points) {
    if (!triangulation_.insert(points) || triangulation_.has_split_segments()) return false;
    triangulation_.number_regions();
    return true;
  }

  const ChartPoint& point(std::size_t i) const { return triangulation_.points()[i]; }

  /// Ascending, each from its first corner.
  std::vector<ChartTriangulation::Triangle> triangles() const {
    std::vector<ChartTriangulation::Triangle> triangles;
    triangles.reserve(triangulation_.triangles().size());
    for (const auto& t : triangulation_.triangles()) {
      if (!is_inside(t)) continue;
      const std::size_t i = least_corner(t);
      triangles.push_back({t.corners[i], t.corners[(i + 1) % 3], t.corners[(i + 2) % 3]});
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }

  double clearance(const ChartPoint& at) {
    const auto* t = holder(at);
    if (t == nullptr) return -1;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < 3; ++i) {
      least = std::min(least, distance(at, point(t->corners[i])));
      if (t->constrained[i])
        least = std::min(least, distance(at, point(t->corners[(i + 1) % 3]),
                                         point(t->corners[(i + 2) % 3]), 2.5));
    }
    return least;
  }

  /// Where to cut a triangle, with the triangle that holds the place.
  ChartTriangulation::Place place_of(const ChartTriangulation::Triangle& corners,
                                     ChartTriangulation::Cut cut) {
    using Cut = ChartTriangulation::Cut;
    const auto middle = [&](std::array<double, 3> weights) {
      ChartTriangulation::Place place{{0, 0}, corners, weights};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 2; ++k) place.at[k] += weights[i] * point(corners[i])[k];
      return place;
    };
    if (cut == Cut::edge0) return middle({0, 0.5, 0.5});
    if (cut == Cut::edge1) return middle({0.5, 0, 0.5});
    if (cut == Cut::edge2) return middle({0.5, 0.5, 0});
    const auto centroid = middle({1.0 / 3, 1.0 / 3, 1.0 / 3});
    const ChartPoint centre = circumcentre(point(corners[0]), point(corners[1]), point(corners[2]));
    if (!std::isfinite(centre[0]) || !std::isfinite(centre[1])) return centroid;
    const auto* t = holder(centre);
    if (t == nullptr) return centroid;
    ChartTriangulation::Place place{centre, {}, {}};
    double total = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (least_corner(*t) + k) % 3;
      const ChartPoint a = minus(point(t->corners[(i + 1) % 3]), centre),
                       b = minus(point(t->corners[(i + 2) % 3]), centre);
      if (t->constrained[i] && product(a, b) < 0) return centroid;
      place.corners[k] = t->corners[i];
      place.weights[k] = std::abs(determinant(a, b));
      total += place.weights[k];
    }
    if (!(total > 0)) return centroid;
    for (auto& w : place.weights) w /= total;
    return place;
  }

 private:
  /// The triangle of a region that contains the place; null outside.
  const ConstrainedDelaunay::Triangle* holder(const ChartPoint& at) {
    const Index t = triangulation_.locate(at);
    if (t == ConstrainedDelaunay::kNone) return nullptr;
    const auto& triangle = triangulation_.triangles()[t];
    return is_inside(triangle) ? &triangle : nullptr;
  }

  ConstrainedDelaunay triangulation_;
};

/// The points that judging asks for.
std::vector<ChartPoint> finer_points(Regions& regions,
                                     const std::vector<ChartTriangulation::Triangle>& triangles,
                                     const std::vector<ChartTriangulation::Cut>& cuts,
                                     const ChartTriangulation::Adding& add) {
  std::vector<ChartTriangulation::Place> places;
  std::vector<double> room;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    if (cuts[k] == ChartTriangulation::Cut::none) continue;
    const auto place = regions.place_of(triangles[k], cuts[k]);
    // Neighbours ask for nearly the same place.
    double least = HUGE_VAL;
    for (const std::size_t corner : triangles[k])
      least = std::min(least, distance(place.at, regions.point(corner), 0.5));
    bool is_free = true;
    for (std::size_t i = 0; i < places.size() && is_free; ++i)
      is_free = distance(places[i].at, place.at) > std::min(least, room[i]);
    if (is_free) places.push_back(place), room.push_back(least);
  }
  std::vector<ChartPoint> points;
  for (const auto& place : places)
    if (const auto point = add(place)) points.push_back(*point);
  return points;
}

}  // namespace

bool ChartTriangulation::build(const std::vector<ChartPoint>& points,
                               const std::vector<std::array<std::size_t, 2>>& segments,
                               const Sampling& samples, const Judging& judge, const Adding& add,
                               int rounds) {
  Regions regions;
  if (!regions.insert(points, segments)) return false;
  const auto inner = samples([&](const ChartPoint& at) { return regions.clearance(at); });
  if (!regions.insert(inner)) return false;
  triangles = regions.triangles();
  for (; rounds > 0; --rounds) {
    const auto finer = finer_points(regions, triangles, judge(triangles), add);
    if (finer.empty()) break;
    if (!regions.insert(finer)) return false;
    triangles = regions.triangles();
  }
  return true;
}

}  // namespace tensortopo
