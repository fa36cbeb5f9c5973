// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

/// A crossing near the barycentric coordinate t of an edge's second vertex.
struct NearCrossing {
  double t = 0;
  bool rising = false;
};

/// Dyadic intervals around the crossings of an edge, in order, which share no more than ends and
/// have different sides of the level at theirs. As many as the edge has crossings, so each holds
/// one; and each holds the coordinate that is given, up to `kRounding`. Where the level nearly
/// touches the edge, that may be far from the crossing: then the interval is coarse.
/// @param is_above  of a coordinate with few enough bits that 1 - t is exact: exactly
/// @return nothing if two crossings are too close to be parted by doubles, or no interval holds
///         both a crossing and its coordinate
template <class IsAbove>
std::optional<std::vector<DyadicBracket>> find_brackets(const std::vector<NearCrossing>& crossings,
                                                        const IsAbove& is_above) {
  // Brackets of few bits are short to write and quick to check, fine ones part close crossings.
  constexpr std::array kDepths{16, 24, 32, 40, 50, 12, 8, 4, 2, 0};
  // A coordinate is a quotient of doubles, each a few units in the last place off.
  constexpr double kRounding = 0x1p-50;
  std::vector<DyadicBracket> brackets;
  double free_from = 0;  // end of the last bracket
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    const auto& crossing = crossings[k];
    const double t = std::clamp(crossing.t, 0.0, 1.0);
    const double next = k + 1 < crossings.size() ? crossings[k + 1].t : 1;
    const auto holds = [&](double place, int depth) {
      const double low = std::ldexp(place, -depth), high = std::ldexp(place + 1, -depth);
      if (place < 0 || high > 1 || low < free_from) return false;
      // The next crossing needs room.
      if (k + 1 < crossings.size() && high >= next) return false;
      return is_above(low) != crossing.rising && is_above(high) == crossing.rising;
    };
    const auto find = [&]() -> std::optional<DyadicBracket> {
      for (const int depth : kDepths) {
        const double place = std::min(std::floor(std::ldexp(t, depth)), std::ldexp(1.0, depth) - 1);
        const double low = std::ldexp(place, -depth), high = std::ldexp(place + 1, -depth);
        for (const double shift : {0.0, -1.0, 1.0})
          if ((shift >= 0 || t - low <= kRounding) && (shift <= 0 || high - t <= kRounding) &&
              holds(place + shift, depth))
            return DyadicBracket{static_cast<std::uint64_t>(place + shift), depth};
      }
      return std::nullopt;
    };
    const auto bracket = find();
    if (!bracket) return std::nullopt;
    free_from = std::ldexp(static_cast<double>(bracket->place + 1), -bracket->depth);
    brackets.push_back(*bracket);
  }
  return brackets;
}

}  // namespace tensortopo
