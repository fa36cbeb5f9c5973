// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "extract/level/level.hpp"

namespace tensortopo {

namespace detail {

/// Isotopic levels are +-(1 - 2^-k), from the first of these k to the last.
inline constexpr int kWidest = 5, kNarrowest = 60;

/// About 1 - mode^2 of the level of number k.
inline double gap_of(int k) { return std::ldexp(2.0, -k); }

/// Next to a critical value cells are small as well: the gap of the level that is taken stays this
/// factor away from it.
inline constexpr double kClearance = 1.3;

/// The gap 1 - mode^2 up to which it is of use to be free of critical values.
inline double widest_gap() { return kClearance * gap_of(kWidest); }

}  // namespace detail

/// Whether surfaces of the level are thin tubes around degenerate curves: cells of a refinement
/// must be as small as a tube is thin, and other proofs pay.
template <class Scalar>
bool is_near_degenerate(const Level<Scalar>& level) {
  return 8 * level.gap() < detail::widest_gap();
}

}  // namespace tensortopo
