// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace tensortopo {

/// Homogeneous barycentric coordinates of a place, exact: each is the sum of two doubles.
template <std::size_t Vertices>
struct ExactPlace {
  std::array<double, Vertices> high{};  ///< the doubles next to the coordinates
  std::array<double, Vertices> low{};   ///< what is left of them

  ExactPlace() = default;
  /// Doubles are exact as they are.
  ExactPlace(const std::array<double, Vertices>& weights) : high(weights) {}
  ExactPlace(const std::array<double, Vertices>& weights, const std::array<double, Vertices>& rest)
      : high(weights), low(rest) {}

  bool fits_in_doubles() const {
    return std::all_of(low.begin(), low.end(), [](double w) { return w == 0; });
  }
};

}  // namespace tensortopo
