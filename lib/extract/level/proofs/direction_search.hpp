// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "extract/level/proofs/level_increase.hpp"

namespace tensortopo {

/// The search of `likely_direction` while it goes on: the nearest point d to the origin of the hull
/// of unit directions, as far as it is known.
template <std::size_t Vertices>
struct DirectionSearch {
  static constexpr std::size_t count = LevelIncrease<double, Vertices>::Cubic::size;

  /// All coefficients should grow at least so fast along the direction, by their own measure: less
  /// would be lost in rounding.
  static constexpr double enough = 0x1p-20;  // of a guess
  /// A hull that comes so close to the origin holds it, for our purposes.
  static constexpr double nothing = 0x1p-9;  // of a guess

  std::array<std::array<double, count>, Vertices> unit;  ///< by coordinate
  std::array<double, count> weight;                      ///< of each in d
  std::array<double, Vertices> d{};

  /// Goes on from a step to the last that is allowed. The result is that of `likely_direction`.
  std::array<double, Vertices> run(int step, int steps);
};

}  // namespace tensortopo
