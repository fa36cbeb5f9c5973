// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Deviators of which each is known up to a ball, in doubles with their errors.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "ball.hpp"

namespace certificate {

/// A trace-free symmetric matrix: 11, 22, 33, 23, 13, 12.
using Matrix = std::array<Ball, 6>;

inline double lower(const Ball& x) { return (x.value - x.error) - std::abs(x.value) * Ball::kUnit; }
inline double upper(const Ball& x) { return (x.value + x.error) + std::abs(x.value) * Ball::kUnit; }

inline Ball inverse(const Ball& x) {
  const double least = std::abs(x.value) - x.error;
  if (!(least > 0)) return {0, HUGE_VAL};
  const double v = 1 / x.value;
  return {v, (x.error / (std::abs(x.value) * least) + std::abs(v) * Ball::kUnit) * Ball::kSlack};
}

/// The root of what is not negative.
inline Ball root(const Ball& x) {
  const double low = std::sqrt(std::max(0.0, lower(x))) / Ball::kSlack,
               high = std::sqrt(std::max(0.0, upper(x))) * Ball::kSlack;
  return {(low + high) / 2, (high - low) * Ball::kSlack};
}

inline Matrix operator+(const Matrix& a, const Matrix& b) {
  Matrix m;
  for (std::size_t k = 0; k < 6; ++k) m[k] = a[k] + b[k];
  return m;
}
inline Matrix operator*(const Ball& x, const Matrix& a) {
  Matrix m;
  for (std::size_t k = 0; k < 6; ++k) m[k] = x * a[k];
  return m;
}

/// tr(A B).
inline Ball inner(const Matrix& a, const Matrix& b) {
  const Ball rest = a[3] * b[3] + a[4] * b[4] + a[5] * b[5];
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + (rest + rest);
}

/// 3 (A B + B A) - 2 tr(A B): six times the gradient, among deviators, of tr(A B C) by C.
inline Matrix sixfold(const Matrix& a, const Matrix& b) {
  const Ball t = Ball(2) * inner(a, b), three(3), six(6);
  const auto sum = [](const Ball& x, const Ball& y, const Ball& z) { return x + y + z; };
  return {six * sum(a[0] * b[0], a[5] * b[5], a[4] * b[4]) - t,
          six * sum(a[5] * b[5], a[1] * b[1], a[3] * b[3]) - t,
          six * sum(a[4] * b[4], a[3] * b[3], a[2] * b[2]) - t,
          three * (sum(a[5] * b[4], a[1] * b[3], a[3] * b[2]) +
                   sum(b[5] * a[4], b[1] * a[3], b[3] * a[2])),
          three * (sum(a[0] * b[4], a[5] * b[3], a[4] * b[2]) +
                   sum(b[0] * a[4], b[5] * a[3], b[4] * a[2])),
          three * (sum(a[0] * b[5], a[5] * b[1], a[4] * b[3]) +
                   sum(b[0] * a[5], b[5] * a[1], b[4] * a[3]))};
}

/// Bounds of the Frobenius norm, for certain: a root of a double is off by less than kUnit of it.
inline double largest_norm(const Matrix& a) {
  return std::sqrt(std::fmax(0, upper(inner(a, a)))) * Ball::kSlack;
}
inline double smallest_norm(const Matrix& a) {
  return std::sqrt(std::fmax(0, lower(inner(a, a)))) / Ball::kSlack;
}

/// Of the modulus.
inline double upper_modulus(const Ball& x) {
  return (std::abs(x.value) + x.error) * Ball::kSlack;
}

/// All deviators within a radius of a matrix.
struct Widened {
  Matrix centre;
  double radius = 0;  ///< rounded up
};

}  // namespace certificate
