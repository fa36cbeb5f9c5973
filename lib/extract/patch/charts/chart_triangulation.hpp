// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace tensortopo {

/// Constrained Delaunay triangulations of plane regions: the regions between the outside and
/// themselves that an odd number of segments separates from the outside.
struct ChartTriangulation {
  using Point = std::array<double, 2>;

  /// How to make a triangle finer: not, amid it, or on the edge opposite a corner.
  enum class Cut : char { none, edge0, edge1, edge2, amid };

  /// A place in a triangle of the regions.
  struct Place {
    Point at;
    std::array<std::size_t, 3> corners;
    std::array<double, 3> weights;  ///< barycentric, not negative
  };

  using Triangle = std::array<std::size_t, 3>;
  /// How far a place in a region is from what bounds it (the nearest corner of its triangle, the
  /// nearest segment of it; negative outside the regions).
  using Clearance = std::function<double(const Point&)>;
  using Sampling = std::function<std::vector<Point>(const Clearance&)>;
  using Judging = std::function<std::vector<Cut>(const std::vector<Triangle>&)>;
  using Adding = std::function<std::optional<Point>(const Place&)>;

  /// Triangulates the regions, and inserts points until no triangle need be finer or the rounds are
  /// over: circumcentres, or where these are close to a segment or outside, the middles of
  /// triangles; middles of edges.
  ///
  /// @param points   distinct
  /// @param segments pairs of points; they may meet in points only
  /// @param samples  asked for once: further points to insert first
  /// @param judge    what each of the triangles needs
  /// @param add      called for a place where to insert a point: the point, numbered after all
  ///                 others, or nothing if there can be none
  /// @return false if segments cross or cover each other, points coincide, or a point that is
  ///         inserted later lies on a segment
  bool build(const std::vector<Point>& points,
             const std::vector<std::array<std::size_t, 2>>& segments, const Sampling& samples,
             const Judging& judge, const Adding& add, int rounds);

  /// Counter-clockwise. Points that were added are numbered after the others; not all of them need
  /// have a triangle.
  std::vector<Triangle> triangles;
};

}  // namespace tensortopo
