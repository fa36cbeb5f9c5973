// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace tensortopo {

/// Constrained Delaunay triangulations of plane regions: the regions between the outside and
/// themselves that an odd number of segments separates from the outside.
struct ChartTriangulation {
  using Point = std::array<double, 2>;

  /// @param points   distinct
  /// @param segments pairs of points; they may meet in points only
  /// @param samples  asked for once, with a function that tells how far a place in a region is from
  ///                 what bounds it (the nearest corner of its triangle, the nearest segment of it;
  ///                 negative outside the regions); returns further points to insert
  /// @return false if segments cross or points coincide
  using Clearance = std::function<double(const Point&)>;
  bool build(const std::vector<Point>& points,
             const std::vector<std::array<std::size_t, 2>>& segments,
             const std::function<std::vector<Point>(const Clearance&)>& samples);

  /// How to make a triangle finer: not, amid it, or on the edge opposite a corner.
  enum class Cut : char { none, edge0, edge1, edge2, amid };

  /// A place in a triangle of the regions.
  struct Place {
    Point at;
    std::array<std::size_t, 3> corners;
    std::array<double, 3> weights;  ///< barycentric, not negative
  };

  /// Triangulates the regions, and inserts points until no triangle need be finer or the rounds are
  /// over: circumcentres, or where these are close to a segment or outside, the middles of
  /// triangles.
  ///
  /// @param cut  what a triangle needs
  /// @param add  called for a place where to insert a point; false if there can be none
  /// @return false as for `build`
  using Cutting = std::function<Cut(const std::array<std::size_t, 3>&)>;
  using Adding = std::function<bool(const Place&)>;
  bool build_fine(const std::vector<Point>& points,
                  const std::vector<std::array<std::size_t, 2>>& segments, const Cutting& cut,
                  const Adding& add, int rounds);

  /// Counter-clockwise; samples are numbered after the points.
  std::vector<std::array<std::size_t, 3>> triangles;
};

}  // namespace tensortopo
