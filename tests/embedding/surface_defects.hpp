// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// What is wrong with a triangulated level of the mode as a surface in space, decided exactly on
/// the coordinates as they are. Nothing here is shared with the extractor.
namespace tensortopo::embedding {

using Point = std::array<double, 3>;

/// A surface whose triangles each lie in one tetrahedron of a field.
struct Surface {
  std::vector<Point> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<std::int32_t> tet;  ///< of each triangle
};

/// A piecewise linear field of symmetric tensors (xx, yy, zz, xy, yz, xz).
struct Field {
  std::vector<Point> points;
  std::vector<std::array<double, 6>> tensors;
  std::vector<std::array<std::int32_t, 4>> tets;
};

/// Two triangles that have a point in common beyond the vertices and the edge that they share.
/// Vertices at one place count as one.
struct Intersection {
  std::size_t first, second;
  enum class Where : std::uint8_t { one_sheet, two_sheets, two_tets } where;
};

struct Intersections {
  std::vector<Intersection> pairs;  ///< ascending
  std::size_t compared = 0;         ///< pairs whose boxes meet
  std::size_t without_area = 0;     ///< triangles that are a segment or a point: not compared
};

Intersections intersections(const Surface& surface);

/// Triangles whose normal has no positive product with the gradient of the mode.
struct AgainstGradient {
  std::vector<std::size_t> at_centroid;  ///< ascending
  std::size_t at_corners = 0;            ///< triangles with such a corner
  std::size_t compared = 0;
};

/// Triangles without area and tetrahedra with an isotropic corner are left out.
AgainstGradient against_gradient(const Surface& surface, const Field& field);

/// The mode that a surface is asked for, exact.
struct Mode {
  std::int64_t numerator, denominator;
};

/// How far the mode at the vertices is from the one asked for.
struct Residuals {
  double largest = 0;
  std::vector<std::size_t> off;  ///< vertices that rounding does not explain, ascending
  std::size_t compared = 0;
};

/// The mode at a vertex depends on its coordinates, which are rounded, and on weights, which are:
/// with u = 2^-53, x the coordinates, w_i and D_i the weights and deviators and D their sum, a
/// vertex is off if its mode is farther from the one asked for than
/// 64 u (1 + |gradient| |x| + sum |w_i D_i| / |D|).
/// A level next to the mode is extracted where the mode is a critical value: 2^-40 of the distance
/// to 1 is allowed as well. Vertices of tetrahedra with an isotropic corner are left out.
Residuals residuals(const Surface& surface, const Field& field, const Mode& mode);

}  // namespace tensortopo::embedding
