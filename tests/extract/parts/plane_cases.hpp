// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "extract/patch/delaunay/constrained_delaunay.hpp"

namespace tensortopo::test {

/// Different points of small whole coordinates, of which all signs are exact in 64 bits, and
/// segments between them that meet in points only.
struct PlaneCase {
  using Segment = std::array<std::size_t, 2>;
  std::vector<ConstrainedDelaunay::Point> points;
  std::vector<Segment> segments;
  bool has_regions = false;  ///< the segments are closed outlines
};

std::int64_t exact_turn(const PlaneCase& c, std::size_t p, std::size_t q, std::size_t r);

/// Positive if the last is inside of the circle through the first three, which turn left.
std::int64_t exact_in_circle(const PlaneCase& c, std::size_t p, std::size_t q, std::size_t r,
                             std::size_t s);

/// Whether two segments meet in a place that is no point of the case, or cover each other in part.
bool are_in_conflict(const PlaneCase& c, const PlaneCase::Segment& s, const PlaneCase::Segment& t);

/// An outline around holes and points, or a lattice with many points on lines and circles, or such
/// a lattice that starts with points on one line.
PlaneCase random_plane_case(std::mt19937& random);

/// Points first, segments next; false if that is refused.
bool insert(const PlaneCase& c, ConstrainedDelaunay& triangulation);

/// "" if this is the triangulation of the case that the header describes.
std::string flaws_of(const PlaneCase& c, const ConstrainedDelaunay& triangulation);

/// Corners of the triangles that are not outside the hull, each from its smallest, ascending.
std::vector<std::array<std::uint32_t, 3>> finite_triangles(
    const ConstrainedDelaunay& triangulation);

}  // namespace tensortopo::test
