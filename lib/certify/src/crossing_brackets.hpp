// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/extract/scaled_field.hpp"

namespace tensortopo {

/// Dyadic intervals around the crossings of an edge, in order, which share no more than ends and
/// have different sides of the level at theirs. As many as the edge has crossings, so each holds
/// one.
/// @return nothing if two crossings are too close to be parted by doubles
std::optional<std::vector<DyadicBracket>> crossing_brackets(const LevelTopology::Edge& edge,
                                                            const ScaledField<double>& field,
                                                            const Level<double>& level);

}  // namespace tensortopo
