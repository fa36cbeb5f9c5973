// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "rational/rational_polynomial.hpp"
#include "tensortopo/scalar/sign.hpp"

namespace tensortopo::detail {

/// The zeros of a polynomial between two numbers, each once, and exact signs at them.
class ExactZeros {
 public:
  /// The only zero between `low` and `high`, which are very close; or equal: the zero itself.
  struct Zero {
    Rational low, high;
  };

  /// @param polynomial  not the zero polynomial; zeros at `low` and `high` do not count
  ExactZeros(const RationalPolynomial& polynomial, const Rational& low, const Rational& high);

  /// In ascending order.
  const std::vector<Zero>& zeros() const { return zeros_; }
  /// The sign of another polynomial at a zero.
  Sign sign_at(const Zero& zero, const RationalPolynomial& other) const;

 private:
  void isolate(const Rational& low, const Rational& high);
  Zero narrowed(Rational low, Rational high) const;

  RationalPolynomial polynomial_;
  RemainderChain chain_;  ///< that counts its zeros
  std::vector<Zero> zeros_;
};

}  // namespace tensortopo::detail
