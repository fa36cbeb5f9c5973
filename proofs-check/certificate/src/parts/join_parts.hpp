// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "parts/part_border.hpp"
#include "run/ledger.hpp"

namespace certificate {

/// The surface that parts form together.
struct JoinedSurface {
  std::size_t vertices = 0, triangles = 0;
  std::vector<Component> components;  ///< in the order of the parts, and of the triangles in these
  long euler_characteristic = 0;
  std::size_t boundary_loops = 0;
  bool has_numbers = false;  ///< the array `whole_component` of triangles was compared
};

/// Faces that two parts have: with one tetrahedron on each side, equal tensors at their points, and
/// the same curves, along which the surfaces of both have vertices at the same places, in opposite
/// directions. One claim for each.
///
/// Curves are known by what both parts derive of the face, and glued as a whole, so vertices at one
/// place are not mistaken for each other. Edges are glued by pairs. So around each vertex the triangles remain one fan, and the result is
/// a surface. Nothing is given if something is refuted, or open.
/// @param borders  of all parts, whose triangles are all as claimed
std::optional<JoinedSurface> join_parts(const std::vector<PartBorder>& borders, Ledger& ledger);

}  // namespace certificate
