// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/level/level.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {

/// The scalar to turn to when rounding leaves a sign inconclusive.
template <class Scalar>
struct Multiprecision;
template <>
struct Multiprecision<double> {
  using type = Real50;
};
template <>
struct Multiprecision<Real50> {
  using type = Real100;
};

/// The level in another scalar; the last one asked for is kept, as all of a run ask for the same.
template <class Scalar>
const Level<Scalar>& level_in(const ModeValue& value) {
  thread_local Level<Scalar> level;
  thread_local bool made = false;
  if (!made || !(level.value == value)) {
    level = make_level<Scalar>(value);
    made = true;
  }
  return level;
}

/// Whether a double hardly tells modes within a tube of the level from that of the tube: 1 - mode^2
/// is of second order in the offset from the degenerate curve. Offsets themselves are exact enough.
/// (At gaps above, more digits cost time and settle nothing.)
template <class Scalar>
bool is_inconclusive_in_double(const Level<Scalar>& level) {
  constexpr double kSmallestGap = 1e-9;
  return static_cast<double>(Scalar(1) - level.mu_squared) < kSmallestGap;
}

}  // namespace tensortopo
