// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "extract/level/proofs/direction_search.hpp"

namespace tensortopo {

/// `likely_direction` with four of the unit directions side by side, bit for bit. Where there are
/// lanes only (`has_lanes`), as the next one.
std::array<double, 3> direction_in_lanes(const LevelIncrease<double, 3>& increase, int steps,
                                         bool of_sum_zero);
std::array<double, 4> direction_in_lanes(const LevelIncrease<double, 4>& increase, int steps,
                                         bool of_sum_zero);

/// `DirectionSearch::run` in the same way.
std::array<double, 3> direction_in_lanes(const DirectionSearch<3>& search, int step, int steps);
std::array<double, 4> direction_in_lanes(const DirectionSearch<4>& search, int step, int steps);

}  // namespace tensortopo
