// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "extract/level/lanes/lanes.hpp"

namespace tensortopo {

// Without linkage, see `Lanes`.
namespace {

/// The unit directions of `likely_direction` from those in which coefficients grow.
template <std::size_t Vertices>
void make_units(std::array<Lanes, Vertices>& unit, bool of_sum_zero) {
  if (of_sum_zero) {
    Lanes mean(0);
    for (const auto& x : unit) mean = mean + x / Lanes(static_cast<int>(Vertices));
    for (auto& x : unit) x = x - mean;
  }
  Lanes square(0);
  for (const auto& x : unit) square = square + x * x;
  const Lanes factor = Lanes(1) / sqrt(square);
  for (auto& x : unit) x = x * factor;
}

}  // namespace
}  // namespace tensortopo
