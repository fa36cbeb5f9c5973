// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace tensortopo {

using Colour = std::array<double, 3>;

inline constexpr Colour kTeal{0.06, 0.58, 0.57};
inline constexpr Colour kGold{0.93, 0.67, 0.13};
inline constexpr Colour kGreen{0.10, 0.62, 0.22};
inline constexpr Colour kYellow{0.98, 0.86, 0.10};
inline constexpr Colour kChartreuse{0.62, 0.85, 0.12};
inline constexpr Colour kPlum{0.56, 0.30, 0.58};
inline constexpr Colour kCrimson{0.76, 0.12, 0.10};
inline constexpr Colour kNavy{0.10, 0.24, 0.66};
inline constexpr Colour kGrey{0.55, 0.60, 0.66};
inline constexpr Colour kInk{0.16, 0.18, 0.21};
inline constexpr Colour kWhite{1, 1, 1};

/// Gives a VTK property a colour.
template <class Property>
void paint(Property& property, const Colour& colour) {
  property.SetColor(colour[0], colour[1], colour[2]);
}

/// How the sheet of one mode looks among the others.
struct Look {
  Colour colour;
  double opacity;
};

inline Colour mix(const Colour& a, const Colour& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

/// One of `count` nested sheets of a colour: the innermost is solid, the others are glass.
/// @param inside  how many are nested in it
inline Look nested(const Colour& base, std::size_t inside, std::size_t count) {
  if (inside == 0) return {count > 1 ? mix(base, {0, 0, 0}, 0.12) : base, 1};
  const double rank = static_cast<double>(inside) / static_cast<double>(count);
  return {mix(base, kWhite, 0.45 * rank), std::max(0.22, 0.6 - 0.4 * rank)};
}

/// Teal for positive modes, gold for negative ones, chartreuse for mode 0; where there are several
/// of a sign, the one furthest from zero, which the others enclose, is solid and the others are
/// glass.
inline Look look_of(std::optional<double> mode, const std::vector<std::optional<double>>& all) {
  if (!mode || *mode == 0) return {mode ? kChartreuse : kGrey, 1};
  if (*mode == 1) return {kGreen, 1};
  if (*mode == -1) return {kYellow, 1};
  std::size_t further = 0, same_sign = 0;
  for (const auto& other : all) {
    if (!other || std::abs(*other) == 1 || *other * *mode <= 0) continue;
    ++same_sign;
    if (std::abs(*other) > std::abs(*mode)) ++further;
  }
  return nested(*mode > 0 ? kTeal : kGold, further, same_sign);
}

/// Plum for other invariants: the largest value is solid, the others are glass.
inline Look look_of_value(double value, const std::vector<std::optional<double>>& all) {
  std::size_t larger = 0, count = 0;
  for (const auto& other : all) {
    if (!other) continue;
    ++count;
    if (*other > value) ++larger;
  }
  return nested(kPlum, larger, count);
}

/// Of what is not proved to be in every field within the noise.
inline Look faded(const Look& look) { return {mix(look.colour, kWhite, 0.5), 0.3 * look.opacity}; }

/// Ridges red, valleys blue.
inline Look look_of_ridges(double kind) { return {kind > 0 ? kCrimson : kNavy, 1}; }

}  // namespace tensortopo
