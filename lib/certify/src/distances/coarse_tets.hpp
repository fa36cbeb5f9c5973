// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "distances/nearby_level.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo::detail {

/// Above a sum of a few lengths, and what rounding of directions adds to it.
inline constexpr double kAboveRounding = 1 + 0x1p-20;

inline double one_norm(const Vector3<double>& x) {
  return std::abs(x.x) + std::abs(x.y) + std::abs(x.z);
}

/// Whether triangles and level are proved to be within a distance of each other, both ways, in one
/// tetrahedron: all points of the triangles are within half of it from some points of them, the
/// level is within the other half from these, and all of the level is within it from one of these.
template <class Cell>
bool are_near(const Cell& cell, const std::array<Place, 4>& vertices,
              const std::vector<std::array<Place, 3>>& triangles, double distance) {
  constexpr std::size_t kMostPoints = 10000, kMostParts = 50000;
  TrianglePoints points(0.5 * distance, kMostPoints);
  for (const auto& triangle : triangles)
    if (!points.add(triangle)) return false;
  CellParts parts(cell, vertices, kMostParts);
  return std::all_of(points.points().begin(), points.points().end(),
                     [&](const Place& p) { return parts.is_near(p, 0.5 * distance); }) &&
         parts.is_covered(points.points(), distance);
}

/// Of the longest edge of a tetrahedron: no smaller distance is looked for by its parts, as the
/// work grows with the square of what it is smaller.
inline constexpr double kSmallestShare = 1.0 / 24;

/// Bounds on distances, both ways, in tetrahedra where triangles, moved, are not proved to stay
/// clear of the level: the longest edge of the tetrahedron, which holds both, or if less is wanted,
/// what `are_near` proves.
///
/// @param triangles  of the surface; those in other tetrahedra are passed over
/// @param coarse     the tetrahedra, ascending
/// @param wanted     no smaller bound is looked for; 0, or a smaller share of the longest edge than
///                   `kSmallestShare`: nothing but that
/// @return for each tetrahedron, with what rounding of places adds
template <class Cells>
std::vector<double> coarse_bounds(const TetMesh& mesh, const SurfaceMesh& surface,
                                  std::span<const std::size_t> triangles,
                                  std::span<const TetMesh::Index> coarse, const Cells& cells,
                                  double wanted) {
  std::vector<std::vector<std::array<Place, 3>>> triangles_in(coarse.size());
  for (const auto i : wanted > 0 ? triangles : std::span<const std::size_t>()) {
    const auto place = std::lower_bound(coarse.begin(), coarse.end(), surface.tet[i]);
    if (place == coarse.end() || *place != surface.tet[i]) continue;
    std::array<Place, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = surface.points[as_size(surface.triangles[i][k])];
    triangles_in[static_cast<std::size_t>(place - coarse.begin())].push_back(corners);
  }
  std::vector<double> result(coarse.size());
  tbb::parallel_for(std::size_t{0}, coarse.size(), [&](std::size_t t) {
    const FloatingPointEnvironment environment;
    const auto cell = cells.at(coarse[t]);
    const auto& v = mesh.tets[as_size(coarse[t])];
    std::array<Place, 4> vertices;
    double rounding = 0x1p-1060;
    for (std::size_t i = 0; i < 4; ++i) {
      vertices[i] = mesh.points[as_size(v[i])];
      // Places of parts and of points of triangles are rounded, at each cut anew.
      rounding += 0x1p-45 * one_norm(vertices[i]);
    }
    const bool is_undefined =
        std::any_of(v.begin(), v.end(), [&](TetMesh::Index i) { return cells.is_undefined_at(i); });
    constexpr double kNext = 2.0 / 3;
    const double least = wanted / kAboveRounding - rounding;
    double distance = cell.size();
    if (least > kSmallestShare * distance && least < distance && !is_undefined) {
      const auto is_proved = [&](double d) { return are_near(cell, vertices, triangles_in[t], d); };
      if (is_proved(least))
        distance = least;
      else
        while (kNext * distance > least && is_proved(kNext * distance)) distance *= kNext;
    }
    result[t] = kAboveRounding * (distance + rounding);
  });
  return result;
}

}  // namespace tensortopo::detail
