// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "tensortopo/io/read_surface_file.hpp"

namespace tensortopo::detail {

/// Appends a point; throws FormatError if it is not finite or one too many for 32 bits.
void add_point(SurfaceFile& surface, const Vector3<double>& point);

/// Appends a list of points. Throws FormatError for a point that is not there, `what` being named.
void add_list(IndexLists& lists, std::span<const std::int64_t> points, const SurfaceFile& surface,
              const char* what);

/// The same for a polygon; one of fewer than three points is left out, as one of no area.
void add_polygon(SurfaceFile& surface, std::span<const std::int64_t> points);

/// The same for a polyline; one of fewer than two points is left out.
void add_line(SurfaceFile& surface, std::span<const std::int64_t> points);

}  // namespace tensortopo::detail
