// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The level in an edge and in a face: of the mesh, or of a cell that is a part of a tetrahedron.
#pragma once

#include <compare>
#include <optional>

#include "refinement.hpp"

namespace certificate {

/// A point of the level on an edge between two roots: the how-manieth from the first.
struct Crossing {
  std::array<std::size_t, 2> edge{};  ///< the two roots, ascending
  unsigned ordinal = 0;

  auto operator<=>(const Crossing&) const = default;
};

/// An edge of a refinement, as a point of the level on it: its ends, ascending.
using CrossedEdge = std::array<Refinement::Id, 2>;

/// The points of a refined simplex along the edge from root a to root b, in that order.
std::vector<Refinement::Id> points_along(const Refinement& refinement, Refinement::Id a,
                                         Refinement::Id b);

/// The curves in a face. An arc runs such that, seen from where the roots are counter-clockwise,
/// the larger modes are left of it.
struct FaceLevel {
  bool decided = false;
  std::vector<std::array<Crossing, 2>> arcs;
  std::vector<std::vector<CrossedEdge>> loops;  ///< of each closed curve the edges that it crosses
  std::shared_ptr<const Refinement> refinement;  ///< if it took one
};
/// @param edges  of the corners 0 and 1, 0 and 2, 1 and 2
/// @param is_fine  cuts a face if an edge is crossed twice
FaceLevel level_in_face(const Level& level, const std::array<Corner, 3>& corners,
                        const std::array<const EdgeLevel*, 3>& edges, bool is_fine = false);

}  // namespace certificate
