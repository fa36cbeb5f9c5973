// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/tools/polynomial.hpp>
#include <cstddef>
#include <vector>

#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::detail {

/// In one variable, the coefficient of the lowest power first.
using RationalPolynomial = boost::math::tools::polynomial<Rational>;

/// Divided by a positive number such that the numbers are integers without a common divisor, which
/// arithmetic is fast for; zeros stay.
template <class Numbers>
void make_primitive(Numbers& numbers) {
  using boost::multiprecision::lcm, boost::multiprecision::gcd;
  using Integer = decltype(numerator(Rational()));
  Integer multiple = 1, divisor = 0;
  for (const Rational& x : numbers) multiple = lcm(multiple, Integer(denominator(x)));
  for (Rational& x : numbers) {
    x *= Rational(multiple);
    divisor = gcd(divisor, Integer(numerator(x)));
  }
  if (divisor > 1)
    for (Rational& x : numbers) x /= Rational(divisor);
}

/// Signed remainders, each times a positive number.
class RemainderChain {
 public:
  RemainderChain(const RationalPolynomial& zeros, const RationalPolynomial& other);
  /// At how many zeros of `zeros` between two numbers, counted once each, `other` is positive, less
  /// how many at which it is negative (Sturm and Tarski). Neither of the two may be a zero.
  int query(const Rational& low, const Rational& high) const;
  /// The same of all real zeros.
  int query() const;

 private:
  std::vector<RationalPolynomial> chain_;
};

/// At how many of the real zeros of `zeros`, counted once each, another polynomial is positive,
/// less how many at which it is negative (Sturm and Tarski). `zeros` must not be the zero
/// polynomial.
int tarski_query(const RationalPolynomial& zeros, const RationalPolynomial& other);

/// The same for the zeros between two numbers. Neither of these may be a zero.
int tarski_query(const RationalPolynomial& zeros, const RationalPolynomial& other,
                 const Rational& low, const Rational& high);

/// Divided such that some numbers are no zeros of it.
/// @pre it is not the zero polynomial
RationalPolynomial without_zeros_at(RationalPolynomial polynomial,
                                    const std::vector<Rational>& places);

/// The polynomial of a degree, or of a smaller one, that has the values of a function.
template <class Function>
RationalPolynomial interpolated(int degree, const Function& value) {
  // Newton's form at 0, 1, 2, ...
  std::vector<Rational> differences;
  for (int i = 0; i <= degree; ++i) differences.push_back(value(Rational(i)));
  for (int order = 1; order <= degree; ++order)
    for (int i = degree; i >= order; --i) {
      auto& d = differences[static_cast<std::size_t>(i)];
      d = (d - differences[static_cast<std::size_t>(i - 1)]) / Rational(order);
    }
  RationalPolynomial sum;
  for (int i = degree; i >= 0; --i)
    sum = sum * RationalPolynomial{Rational(-i), Rational(1)} +
          differences[static_cast<std::size_t>(i)];
  return sum;
}

}  // namespace tensortopo::detail
