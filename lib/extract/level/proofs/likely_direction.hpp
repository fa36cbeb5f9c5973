// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "extract/level/proofs/level_increase.hpp"

namespace tensortopo {

/// A direction along which the mode probably increases wherever a simplex meets the level, of
/// largest entry one: it points to the nearest point to the origin of the convex hull of the
/// directions in which the coefficients of `LevelIncrease` grow (the method of Mitchell, Demyanov
/// and Malozemov, SIAM J. Control 12, 1974). A guess, to be proved: double serves whatever the
/// proof is made in.
///
/// @param steps  how long to search
/// @param of_sum_zero  search only there (off the level almost everything grows towards the middle
///               of the simplex or away from it, which proves nothing)
/// @return zeros if there seems to be none
template <std::size_t Vertices>
std::array<double, Vertices> likely_direction(const LevelIncrease<double, Vertices>& increase,
                                              int steps, bool of_sum_zero);

}  // namespace tensortopo
