// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>

#include "algebra/polynomial.hpp"

namespace proofs {

/// The numbers that a step claims. Each is asked for by value, in the order in which the step uses
/// them; one of them can be changed (increased by one), which should make the step fail.
class Constants {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  explicit Constants(std::size_t changed = none) : changed_(changed) {}

  Polynomial operator()(long numerator, long denominator = 1) {
    Rational value = rational(numerator, denominator);
    if (count_++ == changed_) value += 1;
    return value;
  }
  /// How many were asked for.
  std::size_t count() const { return count_; }

 private:
  std::size_t changed_, count_ = 0;
};

}  // namespace proofs
