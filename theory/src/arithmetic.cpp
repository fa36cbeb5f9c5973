// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/theory/arithmetic.hpp"

#include <algorithm>
#include <cmath>

#include "tensortopo/scalar/sign.hpp"

namespace tensortopo::theory {
namespace {

template <class Real>
double rounded_up(const Real& bound) {
  return std::nextafter(static_cast<double>(bound), std::numeric_limits<double>::infinity());
}

template <class Real>
Bounded<Real> rounded(const Rational& number) {
  // Numerator and denominator are rounded once each: by less than a unit.
  const auto part = [](const auto& integer) {
    const Real v(integer);
    const Real size = v < 0 ? Real(-v) : v;
    return Bounded<Real>(v, size * std::numeric_limits<Real>::epsilon());
  };
  return part(numerator(number)) / part(denominator(number));
}

}  // namespace

std::string_view name(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::rational:
      return "rational";
    case Arithmetic::interval:
      return "interval";
    case Arithmetic::real100:
      return "real100";
    case Arithmetic::real53:
      break;
  }
  return "double";
}

std::optional<Arithmetic> arithmetic_called(std::string_view wanted) {
  for (const Arithmetic arithmetic : kArithmetics) {
    if (name(arithmetic) == wanted) return arithmetic;
  }
  return std::nullopt;
}

template <>
Rational enclosing(const Rational& number) {
  return number;
}

template <>
Interval enclosing(const Rational& number) {
  const double nearest = number.convert_to<double>();
  if (Rational(nearest) == number) return Interval(nearest);
  // The conversion truncates or rounds: a neighbour on either side is enough.
  const double infinity = std::numeric_limits<double>::infinity();
  return {std::nextafter(nearest, -infinity), std::nextafter(nearest, infinity)};
}

template <>
Bounded53 enclosing(const Rational& number) {
  const double nearest = number.convert_to<double>();
  if (Rational(nearest) == number) return {nearest, 0};
  const double unit = std::numeric_limits<double>::epsilon();
  return {nearest, std::abs(nearest) * 2 * unit + std::numeric_limits<double>::min()};
}

template <>
Bounded100 enclosing(const Rational& number) {
  if (denominator(number) == 1 && abs(numerator(number)) < (1 << 30)) {
    return {Real100(numerator(number)), Real100(0)};
  }
  return rounded<Real100>(number);
}

Verdict certified_sign(const Rational& number) {
  return static_cast<Verdict>(static_cast<int>(sign_of(number)));
}

double reach(const Rational&) { return 0; }
double reach(const Interval& number) { return std::max(-number.inf(), number.sup()); }
double reach(const Bounded53& x) { return rounded_up(std::abs(x.value) + x.error); }
double reach(const Bounded100& x) { return rounded_up(Real100(abs(x.value) + x.error)); }

}  // namespace tensortopo::theory
