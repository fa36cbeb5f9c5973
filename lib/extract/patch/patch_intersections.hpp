// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "extract/patch/triangle_pair.hpp"
#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

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

/// Whether all triangles have an area, and any two meet in the vertices and the edge that they
/// share only, exactly. Here points at one place are different vertices.
bool are_embedded(std::span<const Vector3<double>> points,
                  std::span<const PatchTriangle> triangles);

}  // namespace tensortopo
