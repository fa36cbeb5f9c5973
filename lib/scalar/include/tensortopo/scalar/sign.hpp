// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/scalar/scalar_traits.hpp"

namespace tensortopo {

/// The answer of a complete predicate.
enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

/// The answer of one tier of a predicate: a tier that cannot tell says so.
/// There is deliberately no conversion to `Sign`, `bool` or `int`: "unknown" is not "zero".
enum class Verdict : signed char { negative = -1, zero = 0, positive = 1, unknown = 2 };

/// The opposite sign.
constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }

/// The sign of the product of two numbers with the signs given.
constexpr Sign operator*(Sign p, Sign q) {
  return static_cast<Sign>(static_cast<int>(p) * static_cast<int>(q));
}

/// Sign of an ordered number. Not for enclosures: they may not know.
template <OrderedField Scalar>
constexpr Sign sign_of(const Scalar& value) {
  if (value > 0) return Sign::positive;
  if (value < 0) return Sign::negative;
  return Sign::zero;
}

}  // namespace tensortopo
