// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// A corner of a polygon to be cut into triangles.
struct PolygonCorner {
  Vector3<double> position;
  /// Bit f is set if the corner lies on face f of the tetrahedron.
  std::uint8_t faces = 0;
  /// The medium eigenvector, times the root of the length for which a right angle between two of
  /// these counts; zero if they do not count.
  Vector3<double> turned{};
};

/// Cuts a polygon in space into triangles by diagonals of least total length; one of more than
/// `kLargestShortest` corners by the shortest diagonal that cuts a corner off, time and again.
///
/// No diagonal joins two corners on one face: the neighbour across that face may want the same
/// diagonal, and four triangles would meet in it.
/// @return triples of corners in the polygon's direction; empty if no such cut exists, or, beyond
///         `kLargestShortest` corners, if none is found
std::vector<std::array<int, 3>> cut_polygon(std::span<const PolygonCorner> corners);

/// Up to so many corners nothing is allocated but the triangles.
inline constexpr std::size_t kSmallPolygon = 16;

/// The shortest cut takes a time that grows with the cube of the corners: half a tenth of a second
/// for so many.
inline constexpr std::size_t kLargestShortest = 700;

}  // namespace tensortopo
