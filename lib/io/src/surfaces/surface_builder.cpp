// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surfaces/surface_builder.hpp"

#include <cmath>
#include <string>

#include "bytes/format_error.hpp"

namespace tensortopo::detail {

void add_point(SurfaceFile& surface, const Vector3<double>& point) {
  const std::size_t number = surface.points.size();
  if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
    throw FormatError("a coordinate is not finite (point " + std::to_string(number) + ")");
  if (number >= INT32_MAX) throw FormatError("has more points than 32 bits can number");
  surface.points.push_back(point);
}

void add_list(IndexLists& lists, std::span<const std::int64_t> points, const SurfaceFile& surface,
              const char* what) {
  for (const std::int64_t v : points)
    if (v < 0 || static_cast<std::size_t>(v) >= surface.points.size())
      throw FormatError("a " + std::string(what) + " names point " + std::to_string(v) + " of " +
                        std::to_string(surface.points.size()) + " points (" + what + " " +
                        std::to_string(lists.size()) + ")");
  for (const std::int64_t v : points) lists.points.push_back(static_cast<std::int32_t>(v));
  lists.ends.push_back(lists.points.size());
}

void add_polygon(SurfaceFile& surface, std::span<const std::int64_t> points) {
  if (points.size() >= 3) add_list(surface.polygons, points, surface, "polygon");
}

void add_line(SurfaceFile& surface, std::span<const std::int64_t> points) {
  if (points.size() >= 2) add_list(surface.lines, points, surface, "line");
}

}  // namespace tensortopo::detail
