// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/tools/polynomial.hpp>

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

/// At how many of the real zeros of `zeros`, counted once each, another polynomial is positive,
/// less how many at which it is negative (Sturm and Tarski). `zeros` must not be the zero
/// polynomial.
int tarski_query(const RationalPolynomial& zeros, const RationalPolynomial& other);

/// The same for the zeros between 0 and 1. Neither of these may be a zero.
int tarski_query_on_unit(const RationalPolynomial& zeros, const RationalPolynomial& other);

}  // namespace tensortopo::detail
