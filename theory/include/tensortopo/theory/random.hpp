// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::theory {

/// A small generator of its own (splitmix64), so that a seed gives the same numbers with every
/// compiler and standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next();
  /// In [low, high]; of a bias that is of no importance here. Requires low <= high.
  int integer(int low, int high);
  /// A nonzero integer in [-bound, bound].
  int nonzero(int bound);
  /// A fraction with numerator in [-9, 9] and denominator in [1, 5].
  Rational fraction();
  /// A fraction in [0, 1]; 0 and 1 are among them.
  Rational part();

 private:
  std::uint64_t state_;
};

}  // namespace tensortopo::theory
