// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "rational/exact_zeros.hpp"

#include <algorithm>
#include <cstdint>

namespace tensortopo::detail {

namespace {

RationalPolynomial primitive(RationalPolynomial polynomial) {
  make_primitive(polynomial.data());
  return polynomial;
}

}  // namespace

ExactZeros::ExactZeros(const RationalPolynomial& polynomial, const Rational& low,
                       const Rational& high)
    : polynomial_(primitive(without_zeros_at(polynomial, {low, high}))),
      chain_(polynomial_, RationalPolynomial{Rational(1)}) {
  isolate(low, high);
}

/// @pre neither is a zero
void ExactZeros::isolate(const Rational& low, const Rational& high) {
  const int zeros = chain_.query(low, high);
  if (zeros == 0) return;
  if (zeros == 1) {
    zeros_.push_back(narrowed(low, high));
    return;
  }
  // Not at a zero: there are fewer than these places.
  const auto places = static_cast<int>(polynomial_.size()) + 1;
  Rational cut;
  for (int i = 1; i < places; ++i) {
    cut = low + (high - low) * Rational(i) / Rational(places);
    if (polynomial_.evaluate(cut) != 0) break;
  }
  isolate(low, cut);
  isolate(cut, high);
}

/// Until the zero is known to twice as many digits as a double has, and its sign, too.
ExactZeros::Zero ExactZeros::narrowed(Rational low, Rational high) const {
  const Rational root = Rational(1) / Rational(std::int64_t{1} << 50), digits = root * root;
  const auto sign = [&](const Rational& x) { return sign_of(polynomial_.evaluate(x)); };
  const Sign at_low = sign(low);
  const bool changes = sign(high) != at_low;  // not at a double zero
  while (high - low > digits * std::max(Rational(abs(low)), Rational(abs(high)))) {
    const Rational middle = low < 0 && high > 0 ? Rational(0) : Rational((low + high) / 2);
    const Sign there = sign(middle);
    if (there == Sign::zero) return {middle, middle};
    const bool is_lower = changes ? there != at_low : chain_.query(low, middle) == 1;
    (is_lower ? high : low) = middle;
  }
  return {low, high};
}

Sign ExactZeros::sign_at(const Zero& zero, const RationalPolynomial& other) const {
  if (other.is_zero()) return Sign::zero;
  if (zero.low == zero.high) return sign_of(other.evaluate(zero.low));
  const int query = tarski_query(polynomial_, other, zero.low, zero.high);
  return query > 0 ? Sign::positive : query < 0 ? Sign::negative : Sign::zero;
}

}  // namespace tensortopo::detail
