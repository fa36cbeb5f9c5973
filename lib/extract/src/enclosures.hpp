// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/vector3.hpp"

/// \file
/// Two enclosures with one interface: intervals of doubles for almost everything, intervals of
/// rationals for what these leave open. Sources that include this are compiled with
/// -frounding-math.

namespace tensortopo {

/// Only inside the scope of a `FastIntervalScope`: without it every enclosure is wrong.
using FastInterval = CGAL::Interval_nt<false>;
using FastIntervalScope = FastInterval::Protector;

/// An interval with rational ends: no operation rounds.
struct RationalInterval {
  Rational low, high;

  RationalInterval() : low(0), high(0) {}
  explicit RationalInterval(double x) : low(x), high(x) {}
  explicit RationalInterval(const Rational& x) : low(x), high(x) {}
  RationalInterval(const Rational& l, const Rational& h) : low(l), high(h) {}

  friend RationalInterval operator+(const RationalInterval& x, const RationalInterval& y) {
    return {x.low + y.low, x.high + y.high};
  }
  friend RationalInterval operator-(const RationalInterval& x, const RationalInterval& y) {
    return {x.low - y.high, x.high - y.low};
  }
  friend RationalInterval operator-(const RationalInterval& x) { return {-x.high, -x.low}; }
  friend RationalInterval operator*(const RationalInterval& x, const RationalInterval& y) {
    if (x.low == x.high && y.low == y.high) return RationalInterval(Rational(x.low * y.low));
    const std::array<Rational, 4> ends{x.low * y.low, x.low * y.high, x.high * y.low,
                                       x.high * y.high};
    const auto [least, most] = std::minmax_element(ends.begin(), ends.end());
    return {*least, *most};
  }
};

// What certificates ask of an enclosure; `Bound` is the type of its ends.

template <class Enclosure>
struct EnclosureOf;

template <>
struct EnclosureOf<FastInterval> {
  using Bound = double;
  static FastInterval between(double low, double high) { return {low, high}; }
  static Bound low(const FastInterval& x) { return x.inf(); }
  static Bound high(const FastInterval& x) { return x.sup(); }
  static double middle(const FastInterval& x) { return x.inf() + (x.sup() - x.inf()) / 2; }
};

template <>
struct EnclosureOf<RationalInterval> {
  using Bound = Rational;
  static RationalInterval between(const Rational& low, const Rational& high) { return {low, high}; }
  static const Bound& low(const RationalInterval& x) { return x.low; }
  static const Bound& high(const RationalInterval& x) { return x.high; }
  static double middle(const RationalInterval& x) {
    return static_cast<double>(Rational((x.low + x.high) / 2));
  }
};

/// The sign that all numbers of an enclosure share.
template <class Enclosure>
Verdict sign_in(const Enclosure& x) {
  const auto& low = EnclosureOf<Enclosure>::low(x);
  const auto& high = EnclosureOf<Enclosure>::high(x);
  if (low > 0) return Verdict::positive;
  if (high < 0) return Verdict::negative;
  if (low == 0 && high == 0) return Verdict::zero;
  return Verdict::unknown;
}

/// Whether the sign is known, and not zero.
inline bool is_strict(Verdict sign) {
  return sign == Verdict::positive || sign == Verdict::negative;
}

/// The largest magnitude of a number of an enclosure.
template <class Enclosure>
typename EnclosureOf<Enclosure>::Bound magnitude(const Enclosure& x) {
  using Bound = typename EnclosureOf<Enclosure>::Bound;
  const Bound below = -EnclosureOf<Enclosure>::low(x), above = EnclosureOf<Enclosure>::high(x);
  return std::max(below, above);
}

}  // namespace tensortopo
