// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>

#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/scalar_traits.hpp"

namespace tensortopo {

/// The ratio of a circle's circumference to its diameter, rounded to the scalar.
template <RealScalar Scalar>
Scalar pi() {
  if constexpr (std::is_same_v<Scalar, double>) return std::numbers::pi;
  using elementary::atan;
  return Scalar(4) * atan(Scalar(1));
}

/// The square, for formulas in which the argument is long.
template <RingScalar Scalar>
constexpr Scalar squared(const Scalar& x) {
  return x * x;
}

/// `value`, moved to the nearer end of [low, high] if it lies outside.
template <OrderedField Scalar>
constexpr Scalar clamped(const Scalar& value, const Scalar& low, const Scalar& high) {
  if (value < low) return low;
  if (value > high) return high;
  return value;
}

/// The square root of a number that would be >= 0 but for rounding.
template <RealScalar Scalar>
Scalar root_of_nonnegative(const Scalar& x) {
  using std::sqrt;
  return x > Scalar(0) ? Scalar(sqrt(x)) : Scalar(0);
}

}  // namespace tensortopo
