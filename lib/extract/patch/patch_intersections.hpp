// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// Triangles between places in a list of points.
using PatchTriangle = std::array<std::uint32_t, 3>;

/// Pairs of triangles, ascending.
struct IntersectingPairs {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  std::size_t tested = 0;  ///< pairs that no box told apart
  bool are_all = true;     ///< false: more were not looked for
};

/// Pairs of triangles with a point in common beyond the vertices and the edge that they share,
/// decided exactly on the coordinates as they are. Points at one place count as one vertex.
/// Triangles without area are left out.
/// @param most_tested  after so many tests one pair will do: what is not found then may be many
IntersectingPairs intersecting_pairs(std::span<const Vector3<double>> points,
                                     std::span<const PatchTriangle> triangles,
                                     std::size_t most_tested = SIZE_MAX);

/// Whether some of the first triangles and one of the others are such a pair, or two of the first.
/// @return nothing if none are; else the place in its list of such another, or the length of that
///         list if two of the first are
std::optional<std::size_t> find_intersection(std::span<const Vector3<double>> points,
                                             std::span<const PatchTriangle> first,
                                             std::span<const PatchTriangle> others);

/// Whether `find_intersection` finds one.
bool intersects_any(std::span<const Vector3<double>> points, std::span<const PatchTriangle> first,
                    std::span<const PatchTriangle> others);

/// Whether all triangles have an area, and any two meet in the vertices and the edge that they share
/// only, exactly. Here points at one place are different vertices.
bool are_embedded(std::span<const Vector3<double>> points,
                  std::span<const PatchTriangle> triangles);

}  // namespace tensortopo
