// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "extract/level/level.hpp"
#include "extract/patch/patch.hpp"

namespace tensortopo {

enum class Folded { kept, unfolded };

/// Exchanges diagonals of a tetrahedron's triangles where the other one is closer to the level or
/// has better angles: a chart is true to the eigenvectors' turning, not to space.
///
/// Laws      (1) the complex stays homeomorphic, with the same boundary loops, and no edge beside
///           them joins two boundary loop vertices on one face; (2) unless triangles are unfolded,
///           the squared distances from the level, as a quadratic function of those of the edges'
///           middles, to first order and by area, do not grow.
/// @param patch the planned sheets, directed (see `direct_as_proved`)
/// @param folded what is done where two triangles with a common edge are folded onto each other, at
///               90 degrees or more, and would not be with the other diagonal
/// @return how many
template <class Scalar>
std::size_t flip_edges(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                       std::span<const std::vector<BoundaryVertex>> boundaries,
                       Patch<Scalar>& patch, Folded folded = Folded::kept);

}  // namespace tensortopo
