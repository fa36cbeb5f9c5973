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
};

/// Cuts a polygon in space into triangles by diagonals of least total length; one of more than
/// `kSmallPolygon` corners by the shortest diagonal that cuts a corner off, time and again.
///
/// No diagonal joins two corners on one face: the neighbour across that face may want the same
/// diagonal, and four triangles would meet in it.
/// @return triples of corners in the polygon's direction; empty if no such cut exists, or none is
///         found for many corners
std::vector<std::array<int, 3>> cut_polygon(std::span<const PolygonCorner> corners);

inline constexpr std::size_t kSmallPolygon = 16;

}  // namespace tensortopo
