// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "rational_polynomial.hpp"

#include <vector>

#include "tensortopo/scalar/sign.hpp"

namespace tensortopo::detail {

namespace {

using Chain = std::vector<RationalPolynomial>;

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

// Signed remainders, each times a positive number.
Chain signed_remainders(const RationalPolynomial& zeros, const RationalPolynomial& other) {
  Chain chain{zeros};
  RationalPolynomial next = remainder(zeros.prime() * remainder(other, zeros), zeros);
  while (!next.is_zero()) {
    chain.push_back(next);
    if (next.degree() == 0) break;
    const auto& before = chain[chain.size() - 2];
    next = RationalPolynomial{} - remainder(before, chain.back());
  }
  return chain;
}

template <class SignOf>
int variations(const Chain& chain, const SignOf& sign) {
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

int tarski_query(const RationalPolynomial& zeros, const RationalPolynomial& other) {
  if (zeros.degree() == 0) return 0;
  const Chain chain = signed_remainders(zeros, other);
  const auto at_infinity = [](const RationalPolynomial& p) { return sign_of(p.data().back()); };
  return variations(chain,
                    [&](const RationalPolynomial& p) {
                      return p.degree() % 2 == 0 ? at_infinity(p) : -at_infinity(p);
                    }) -
         variations(chain, at_infinity);
}

int tarski_query_on_unit(const RationalPolynomial& zeros, const RationalPolynomial& other) {
  if (zeros.degree() == 0) return 0;
  const Chain chain = signed_remainders(zeros, other);
  const auto at = [](int x) {
    return [x](const RationalPolynomial& p) { return sign_of(p.evaluate(Rational(x))); };
  };
  return variations(chain, at(0)) - variations(chain, at(1));
}

}  // namespace tensortopo::detail
