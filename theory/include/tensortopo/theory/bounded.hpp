// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "tensortopo/scalar/scalar_traits.hpp"
#include "tensortopo/scalar/sign.hpp"

namespace tensortopo::theory {

/// A rounded number together with a bound on its distance from the number that it stands for.
///
/// Running error analysis: each operation adds its own rounding to what its operands carry, and
/// the bound is rounded up. So a sign that the bound does not reach is certain, as it is with
/// intervals; but the value is the one that plain arithmetic gives.
template <RealScalar Real>
struct Bounded {
  Real value{};
  Real error{};  ///< >= 0; infinite if nothing is known

  Bounded() = default;
  Bounded(int integer) : value(integer) {}
  Bounded(const Real& v, const Real& e) : value(v), error(e) {}

  friend Bounded operator+(const Bounded& p, const Bounded& q) {
    const Real v = p.value + q.value;
    return {v, rounded_up(p.error + q.error + unit() * magnitude(v))};
  }
  friend Bounded operator-(const Bounded& p) { return {-p.value, p.error}; }
  friend Bounded operator-(const Bounded& p, const Bounded& q) { return p + -q; }
  friend Bounded operator*(const Bounded& p, const Bounded& q) {
    const Real v = p.value * q.value;
    return {v, rounded_up(magnitude(p.value) * q.error + magnitude(q.value) * p.error +
                          p.error * q.error + unit() * magnitude(v)) +
                   std::numeric_limits<Real>::min()};
  }
  friend Bounded operator/(const Bounded& p, const Bounded& q) {
    const Real room = magnitude(q.value) - q.error;
    if (!(room > 0)) return {Real(0), std::numeric_limits<Real>::infinity()};
    const Real v = p.value / q.value;
    const Real share = p.error + magnitude(v) * q.error + unit() * magnitude(v * q.value);
    return {v, rounded_up(share / room) + std::numeric_limits<Real>::min()};
  }

 private:
  // At least the relative error of an operation, in any rounding direction.
  static Real unit() { return std::numeric_limits<Real>::epsilon(); }
  static Real magnitude(const Real& v) { return v < 0 ? Real(-v) : v; }
  // Bounds are sums and products of at most seven numbers that are not negative.
  static Real rounded_up(const Real& bound) { return bound * (Real(1) + Real(16) * unit()); }
};

template <RealScalar Real>
Verdict certified_sign(const Bounded<Real>& x) {
  if (x.value > x.error) return Verdict::positive;
  if (-x.value > x.error) return Verdict::negative;
  return x.value == 0 && x.error == 0 ? Verdict::zero : Verdict::unknown;
}

}  // namespace tensortopo::theory

template <class Real>
struct tensortopo::ScalarTraits<tensortopo::theory::Bounded<Real>> {
  static constexpr bool is_exact = false;
  static constexpr bool has_roots = false;
  static constexpr bool is_enclosure = true;
};
