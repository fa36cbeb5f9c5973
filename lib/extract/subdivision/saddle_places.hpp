// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "extract/subdivision/refinement.hpp"

namespace tensortopo::detail {

/// Where a line of saddles meets the edges and the faces of a tetrahedron, at most one place for
/// each of these: the mode is next to the level there and hardly changes in any direction. In a
/// field with a uniaxial characteristic tensor n n^T - I/3 it is the line on which n is an
/// eigenvector, and the neutral surface crosses itself there; in a field next to such a one the
/// surface turns sharply along it.
///
/// Found by Newton iterations; it says where vertices are better put, and nothing about the level.
///
/// @return shares of the corners, 0 for those that an edge or a face is without; a face with an
///     edge that has a place has none of its own
template <class Scalar>
std::vector<std::array<std::int64_t, 4>> saddle_places(const LevelSimplex<Scalar, 4>& simplex,
                                                       const Level<Scalar>& level);

}  // namespace tensortopo::detail
