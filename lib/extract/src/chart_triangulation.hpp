// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace tensortopo {

/// A constrained Delaunay triangulation of plane regions: the regions between the outside and
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

  /// Counter-clockwise; samples are numbered after the points.
  std::vector<std::array<std::size_t, 3>> triangles;
};

}  // namespace tensortopo
