// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tensortopo/extract/level.hpp"
#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

/// Exchanges diagonals of a tetrahedron's triangles where the other one is closer to the level or
/// has better angles: a chart is true to the eigenvectors' turning, not to space.
///
/// Laws      (1) the complex stays homeomorphic, with the same rims, and no edge beside them joins
///           two rim vertices on one face; (2) the squared distances from the level, as a quadratic
///           function of those of the edges' middles, to first order and by area, do not grow.
/// @param drawn the planned sheets, directed (see `direct_as_planned`)
/// @return how many
template <class Scalar>
std::size_t flip_edges(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                       std::span<const std::vector<RimVertex>> rims, TetTriangles<Scalar>& drawn);

}  // namespace tensortopo
