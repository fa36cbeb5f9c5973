// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/vector3.hpp"

/// \file
/// Two enclosures with one interface: intervals of doubles for almost everything, intervals of
/// 150 digits for what these leave open. Sources that include this are compiled with
/// -frounding-math.

namespace tensortopo {

/// Only inside the scope of a `FastIntervalScope`: without it every enclosure is wrong.
using FastInterval = CGAL::Interval_nt<false>;
using FastIntervalScope = FastInterval::Protector;

/// An interval with ends of 150 digits, each rounded outward.
struct MultiprecisionInterval {
  using End = Real<150>;
  End low, high;

  MultiprecisionInterval() : low(0), high(0) {}
  explicit MultiprecisionInterval(double x) : low(x), high(x) {}
  explicit MultiprecisionInterval(const Real100& x) : low(x), high(x) {}
  MultiprecisionInterval(const End& l, const End& h) : low(l), high(h) {}

  friend MultiprecisionInterval operator+(const MultiprecisionInterval& x,
                                          const MultiprecisionInterval& y) {
    MultiprecisionInterval sum;
    mpfr_add(raw(sum.low), raw(x.low), raw(y.low), MPFR_RNDD);
    mpfr_add(raw(sum.high), raw(x.high), raw(y.high), MPFR_RNDU);
    return sum;
  }
  friend MultiprecisionInterval operator-(const MultiprecisionInterval& x,
                                          const MultiprecisionInterval& y) {
    MultiprecisionInterval difference;
    mpfr_sub(raw(difference.low), raw(x.low), raw(y.high), MPFR_RNDD);
    mpfr_sub(raw(difference.high), raw(x.high), raw(y.low), MPFR_RNDU);
    return difference;
  }
  friend MultiprecisionInterval operator-(const MultiprecisionInterval& x) {
    return {End(-x.high), End(-x.low)};
  }
  friend MultiprecisionInterval operator*(const MultiprecisionInterval& x,
                                          const MultiprecisionInterval& y) {
    MultiprecisionInterval product;
    mpfr_mul(raw(product.low), raw(x.low), raw(y.low), MPFR_RNDD);
    mpfr_mul(raw(product.high), raw(x.low), raw(y.low), MPFR_RNDU);
    const auto extend = [&](const End& p, const End& q) {
      End end;
      mpfr_mul(raw(end), raw(p), raw(q), MPFR_RNDD);
      mpfr_min(raw(product.low), raw(product.low), raw(end), MPFR_RNDD);
      mpfr_mul(raw(end), raw(p), raw(q), MPFR_RNDU);
      mpfr_max(raw(product.high), raw(product.high), raw(end), MPFR_RNDU);
    };
    extend(x.low, y.high);
    extend(x.high, y.low);
    extend(x.high, y.high);
    return product;
  }

 private:
  static mpfr_ptr raw(End& x) { return x.backend().data(); }
  static mpfr_srcptr raw(const End& x) { return x.backend().data(); }
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
struct EnclosureOf<MultiprecisionInterval> {
  using Bound = MultiprecisionInterval::End;
  static MultiprecisionInterval between(const Bound& low, const Bound& high) { return {low, high}; }
  static const Bound& low(const MultiprecisionInterval& x) { return x.low; }
  static const Bound& high(const MultiprecisionInterval& x) { return x.high; }
  static double middle(const MultiprecisionInterval& x) {
    return static_cast<double>(Bound((x.low + x.high) / 2));
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
