// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "extract/level/edge_crossing.hpp"
#include "extract/level/level.hpp"
#include "tensortopo/extract/level_simplex.hpp"

namespace tensortopo {

/// All points of the level on an edge, in order from the first vertex: the count is proved, by
/// cutting the edge at dyadic points until each part holds at most one and the exact sides of its
/// ends tell whether it does.
///
/// The weights refer to the scaled vertex tensors of `edge`. Its vertices must come in the order
/// of their global ids, so that everyone who asks computes the same bits.
/// @return nothing if the parts get too small (the level touches the edge or runs along it)
template <class Scalar>
std::optional<std::vector<EdgeCrossing<Scalar>>> edge_crossings(const LevelSimplex<Scalar, 2>& edge,
                                                                const Level<Scalar>& level);

}  // namespace tensortopo
