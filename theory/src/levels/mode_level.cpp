// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "levels/mode_level.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo::theory {
namespace {

// Entries this much smaller than the largest, in powers of two, count as an error only.
constexpr long kNegligible = 900;

// The integer divided by 2^shift. GMP cuts the mantissa after 53 bits.
Bounded<double> scaled(const Integer& integer, long shift) {
  if (integer == 0) return {};
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, integer.backend().data());
  const long power = exponent - shift;
  if (power < -kNegligible) return {0, std::ldexp(1.0, -static_cast<int>(kNegligible))};
  const double cut = exponent > 53 ? std::ldexp(1.0, static_cast<int>(power) - 53) : 0.0;
  return {std::ldexp(mantissa, static_cast<int>(power)), cut};
}

Deviator<Integer> divided(const Deviator<Integer>& t, const Integer& by) {
  return {t.a / by, t.b / by, t.xy / by, t.yz / by, t.xz / by};
}

Rational as_rational(const Integer& integer) { return Rational(integer); }

}  // namespace

ModeLevel ModeLevel::of_parameter(const Rational& s, int sign) {
  return {mode_squared_from_s2(Rational(s * s)), sign};
}

Deviator<Integer> primitive(const Deviator<Rational>& t) {
  Integer common(1);
  for (const Rational* entry : {&t.a, &t.b, &t.xy, &t.yz, &t.xz}) {
    common = lcm(common, Integer(denominator(*entry)));
  }
  const auto whole = [&](const Rational& entry) {
    return Integer(numerator(entry)) * (common / Integer(denominator(entry)));
  };
  return primitive(
      Deviator<Integer>{whole(t.a), whole(t.b), whole(t.xy), whole(t.yz), whole(t.xz)});
}

Deviator<Integer> primitive(const Deviator<Integer>& t) {
  Integer common(0);
  for (const Integer* entry : {&t.a, &t.b, &t.xy, &t.yz, &t.xz}) common = gcd(common, *entry);
  return common == 0 ? t : divided(t, common);
}

long binary_size(const Deviator<Integer>& t) {
  long size = 0;
  for (const Integer* entry : {&t.a, &t.b, &t.xy, &t.yz, &t.xz}) {
    if (*entry != 0) size = std::max(size, static_cast<long>(msb(Integer(abs(*entry)))));
  }
  return size;
}

BoundedDeviator bounded(const Deviator<Integer>& t, long shift) {
  return {scaled(t.a, shift), scaled(t.b, shift), scaled(t.xy, shift), scaled(t.yz, shift),
          scaled(t.xz, shift)};
}

bool is_above(const Deviator<Integer>& t, const ModeLevel& level) {
  const Integer q = determinant_form(t), p = norm_form(t);
  if (level.is_neutral()) return q > 0;
  // On the side of 0 that the level is not on.
  if (level.sign > 0 ? q <= 0 : q >= 0) return level.sign < 0;
  const Rational excess =
      as_rational(Integer(2) * q * q) - level.mu_squared * as_rational(p * p * p);
  return level.sign > 0 ? excess > 0 : excess < 0;
}

Verdict side(const BoundedDeviator& t, const ModeLevel& level, const Bounded<double>& square) {
  const Bounded<double> q = determinant_form(t);
  const Verdict of_q = certified_sign(q);
  if (level.is_neutral() || of_q == Verdict::unknown) return of_q;
  const Verdict at_level = level.sign > 0 ? Verdict::positive : Verdict::negative;
  const Verdict opposite = level.sign > 0 ? Verdict::negative : Verdict::positive;
  if (of_q != at_level) return opposite;
  const Bounded<double> p = norm_form(t);
  const Verdict excess = certified_sign(Bounded<double>(2) * q * q - square * (p * p * p));
  if (level.sign > 0 || excess == Verdict::unknown || excess == Verdict::zero) return excess;
  return excess == Verdict::positive ? Verdict::negative : Verdict::positive;
}

}  // namespace tensortopo::theory
