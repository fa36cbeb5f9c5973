// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "plane/polynomial.hpp"

namespace tensortopo::theory {

/// The real zeros of a square-free polynomial, in ascending order.
class RealZeros {
 public:
  /// Requires a nonzero square-free polynomial.
  explicit RealZeros(const Polynomial& squarefree);

  std::size_t count() const { return zeros_.size(); }
  /// The sign of q at each zero: zero where a common divisor is, and elsewhere that of q on an
  /// interval so short that q keeps its sign there.
  std::vector<Sign> signs(const Polynomial& q) const;
  /// The sign at one of them.
  Sign sign(const Polynomial& q, std::size_t zero) const;

 private:
  /// It contains one zero, and the polynomial is not zero at its ends.
  struct Interval {
    Rational low, high;
  };
  void halve(Interval& interval) const;
  Sign sign(const Polynomial& q, const Polynomial& common, Interval interval) const;

  Polynomial polynomial_;
  std::vector<Interval> zeros_;
};

}  // namespace tensortopo::theory
