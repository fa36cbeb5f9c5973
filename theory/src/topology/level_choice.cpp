// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology/level_choice.hpp"

#include <algorithm>
#include <cmath>

namespace tensortopo::theory {
namespace {

// Parameters are fractions of this denominator: a prime, so that none is critical by chance.
constexpr int kFractions = 1009;

// Room needed on either side, in the same units: tubes around degenerate curves get thin.
constexpr int kLeastBelow = 25, kLeastAbove = 150;

}  // namespace

LevelChoice level_choice(const Tensor& normal, Random& random) {
  const double of_normal = mode_squared(normal).convert_to<double>();
  const double critical = std::asin(std::sqrt(std::clamp(1 - of_normal, 0.0, 1.0)));
  const double s0 = std::sqrt(3.0) * std::tan(critical / 3);
  const int at = std::clamp(static_cast<int>(std::lround(kFractions * s0)), 0, kFractions);
  const int below = random.integer(3, 8), above = random.integer(2, 6);
  LevelChoice choice;
  if (at > kLeastBelow) choice.below = fraction(at * below / 10, kFractions);
  if (at < kFractions - kLeastAbove)
    choice.above = fraction(at + (kFractions - at) * above / 10, kFractions);
  return choice;
}

}  // namespace tensortopo::theory
