// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "rational/rational_polynomial.hpp"

#include <vector>

#include "tensortopo/scalar/sign.hpp"

namespace tensortopo::detail {

namespace {

RationalPolynomial remainder(const RationalPolynomial& p, const RationalPolynomial& divisor) {
  if (p.is_zero() || p.degree() < divisor.degree()) return p;
  // Times a power of its first coefficient, so that the quotient is in integers.
  const Rational first = abs(divisor.data().back());
  RationalPolynomial multiple = p;
  for (auto d = divisor.degree(); d <= p.degree(); ++d) multiple *= first;
  RationalPolynomial rest = multiple % divisor;
  make_primitive(rest.data());
  return rest;
}

template <class SignOf>
int variations(const std::vector<RationalPolynomial>& chain, const SignOf& sign) {
  int count = 0;
  Sign last = Sign::zero;
  for (const auto& p : chain) {
    const Sign s = sign(p);
    if (s == Sign::zero) continue;
    if (last != Sign::zero && s != last) ++count;
    last = s;
  }
  return count;
}

}  // namespace

RemainderChain::RemainderChain(const RationalPolynomial& zeros, const RationalPolynomial& other)
    : chain_{zeros} {
  if (zeros.degree() == 0) return;
  RationalPolynomial next = remainder(zeros.prime() * remainder(other, zeros), zeros);
  while (!next.is_zero()) {
    chain_.push_back(next);
    if (next.degree() == 0) break;
    const auto& before = chain_[chain_.size() - 2];
    next = RationalPolynomial{} - remainder(before, chain_.back());
  }
}

int RemainderChain::query(const Rational& low, const Rational& high) const {
  const auto at = [](const Rational& x) {
    return [&x](const RationalPolynomial& p) { return sign_of(p.evaluate(x)); };
  };
  return variations(chain_, at(low)) - variations(chain_, at(high));
}

int RemainderChain::query() const {
  const auto at_infinity = [](const RationalPolynomial& p) { return sign_of(p.data().back()); };
  const auto at_minus_infinity = [&](const RationalPolynomial& p) {
    return p.degree() % 2 == 0 ? at_infinity(p) : -at_infinity(p);
  };
  return variations(chain_, at_minus_infinity) - variations(chain_, at_infinity);
}

int tarski_query(const RationalPolynomial& zeros, const RationalPolynomial& other) {
  return RemainderChain(zeros, other).query();
}

int tarski_query(const RationalPolynomial& zeros, const RationalPolynomial& other,
                 const Rational& low, const Rational& high) {
  return RemainderChain(zeros, other).query(low, high);
}

RationalPolynomial without_zeros_at(RationalPolynomial polynomial,
                                    const std::vector<Rational>& places) {
  for (const Rational& place : places)
    while (polynomial.evaluate(place) == 0)
      polynomial /= RationalPolynomial{Rational(-place), Rational(1)};
  return polynomial;
}

}  // namespace tensortopo::detail
