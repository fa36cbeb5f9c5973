// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tensortopo::elementary {

/// The number hi + lo, with |lo| at most half a unit in the last place of hi. (Dekker 1971.)
///
/// Sums and products have relative errors below 2^-100 for numbers whose products neither overflow
/// nor underflow. Without fused multiply-add, so that every processor gives the same bits.
struct DoubleDouble {
  double hi = 0, lo = 0;
};

/// hi + lo for |hi| >= |lo|, exactly.
constexpr DoubleDouble ordered_sum(double hi, double lo) {
  const double sum = hi + lo;
  return {sum, lo - (sum - hi)};
}

/// a + b, exactly.
constexpr DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// The upper 26 bits of a number, and the rest.
constexpr DoubleDouble halves(double a) {
  const double shifted = 134217729.0 * a, hi = shifted - (shifted - a);
  return {hi, a - hi};
}

/// a * b, exactly.
constexpr DoubleDouble exact_product(double a, double b) {
  const double product = a * b;
  const DoubleDouble s = halves(a), t = halves(b);
  return {product, ((s.hi * t.hi - product) + s.hi * t.lo + s.lo * t.hi) + s.lo * t.lo};
}

constexpr DoubleDouble operator-(const DoubleDouble& a) { return {-a.hi, -a.lo}; }

constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = exact_sum(a.hi, b.hi), low = exact_sum(a.lo, b.lo);
  const DoubleDouble sum = ordered_sum(high.hi, high.lo + low.hi);
  return ordered_sum(sum.hi, sum.lo + low.lo);
}
constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = exact_product(a.hi, b.hi);
  return ordered_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}
constexpr DoubleDouble operator*(double a, const DoubleDouble& b) { return DoubleDouble{a, 0} * b; }

/// 1 / n, to twice the precision.
constexpr DoubleDouble inverse(double n) {
  const double hi = 1 / n;
  const DoubleDouble product = exact_product(hi, n);
  return ordered_sum(hi, ((1 - product.hi) - product.lo) / n);
}

/// n! for n <= 18, which is exact.
constexpr double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

/// The coefficient of x^N in the series of exp, and but for its sign of sin or cos.
template <int N>
constexpr DoubleDouble kCoefficient = inverse(factorial(N));

}  // namespace tensortopo::elementary
