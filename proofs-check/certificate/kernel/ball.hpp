// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <cfloat>
#include <cmath>

#if defined(__FAST_MATH__) || FLT_EVAL_METHOD != 0
#error "the error bounds need IEEE doubles"
#endif

namespace certificate {

/// A real number known up to an error: |x - value| <= error.
///
/// One operation of IEEE doubles, in any rounding mode, is off by at most 2^-52 of its result, or
/// by 2^-1000 (by far) where it underflows or is flushed to zero. Errors are sums of positive
/// terms of at most eight operations, so a factor 1 + 2^-40 covers the rounding of the error
/// itself. Whatever overflows ends as an infinite or NaN error, which decides nothing.
struct Ball {
  double value = 0, error = 0;

  static constexpr double kUnit = 0x1p-52, kTiny = 0x1p-1000, kSlack = 1 + 0x1p-40;

  Ball() = default;
  Ball(int exact) : value(exact) {}
  Ball(double v, double e) : value(v), error(e) {}

  friend Ball operator+(const Ball& a, const Ball& b) {
    const double v = a.value + b.value;
    return {v, (a.error + b.error + std::abs(v) * kUnit + kTiny) * kSlack};
  }
  friend Ball operator-(const Ball& a, const Ball& b) { return a + Ball(-b.value, b.error); }
  friend Ball operator*(const Ball& a, const Ball& b) {
    const double v = a.value * b.value;
    return {v, (std::abs(a.value) * b.error + a.error * (std::abs(b.value) + b.error) +
                std::abs(v) * kUnit + kTiny) * kSlack};
  }
  Ball& operator+=(const Ball& b) { return *this = *this + b; }
  Ball& operator-=(const Ball& b) { return *this = *this - b; }
};

enum class Answer : unsigned char { no, yes, unsure };

/// Both, or one of them; the second is asked only if need be.
inline Answer both(Answer first, const auto& second) {
  if (first == Answer::no) return first;
  const Answer other = second();
  return other == Answer::no || first == Answer::yes ? other : first;
}
inline Answer either(Answer first, const auto& second) {
  if (first == Answer::yes) return first;
  const Answer other = second();
  return other == Answer::yes || first == Answer::no ? other : first;
}

enum class Zero : bool { fails, will_do };

/// Has x this sign, 1 or -1? (The zero in doubles may be any small number.)
inline Answer has_sign(const Ball& x, int sign, Zero) {
  const double v = sign * x.value;
  return v > x.error ? Answer::yes : -v > x.error ? Answer::no : Answer::unsure;
}
inline Answer has_sign(const mpz_class& x, int sign, Zero zero) {
  const int s = sgn(x) * sign;
  return s > 0 || (s == 0 && zero == Zero::will_do) ? Answer::yes : Answer::no;
}

/// x / 2^shift, enclosed.
inline Ball ball_of(const mpz_class& x, long shift) {
  signed long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, x.get_mpz_t());  // truncated, in [1/2, 1)
  if (mantissa == 0) return {};
  const long e = exponent - shift;
  if (e > 1000) return {0, HUGE_VAL};
  if (e < -900) return {0, 0x1p-899};
  const double v = std::ldexp(mantissa, static_cast<int>(e));
  return {v, std::abs(v) * (2 * Ball::kUnit)};
}

/// x / y to about the size of y, enclosed: x / 2^(bits of y).
inline Ball scaled(const mpz_class& x, const mpz_class& y) {
  return ball_of(x, static_cast<long>(mpz_sizeinbase(y.get_mpz_t(), 2)));
}

}  // namespace certificate
