// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

/// \file
/// Polynomials on [0, 1] by their coefficients c_k in sum_k c_k t^k (1 - t)^(n - k): those of
/// Bernstein without the binomials. A product is a convolution, and the signs are Bernstein's.

namespace tensortopo {

/// The parameters [index / 2^depth, (index + 1) / 2^depth].
struct DyadicInterval {
  std::uint64_t index = 0;
  int depth = 0;

  DyadicInterval left() const { return {2 * index, depth + 1}; }
  DyadicInterval right() const { return {2 * index + 1, depth + 1}; }
};

/// The product of two polynomials, whose coefficients are multiplied by `multiply`.
template <class A, class B, std::size_t N, std::size_t M, class Multiply>
auto convolved(const std::array<A, N>& a, const std::array<B, M>& b, const Multiply& multiply) {
  using C = std::decay_t<decltype(multiply(a[0], b[0]))>;
  std::array<C, N + M - 1> product;
  std::array<bool, N + M - 1> begun{};
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < M; ++j) {
      const C term = multiply(a[i], b[j]);
      product[i + j] = begun[i + j] ? C(product[i + j] + term) : term;
      begun[i + j] = true;
    }
  return product;
}

template <class E, std::size_t N, std::size_t M>
std::array<E, N + M - 1> product_of(const std::array<E, N>& a, const std::array<E, M>& b) {
  return convolved(a, b, [](const E& x, const E& y) { return E(x * y); });
}

/// 2^n times the polynomial at t / 2.
template <class E, std::size_t N>
std::array<E, N> left_half(const std::array<E, N>& p) {
  // With x = t and y = 1 - t at the half: x^k (x + 2 y)^(n - k).
  std::array<E, N> shifted;
  for (std::size_t j = 0; j < N; ++j) shifted[j] = p[N - 1 - j];
  for (std::size_t i = 0; i + 1 < N; ++i)
    for (std::size_t j = N - 1; j-- > i;) shifted[j] = shifted[j] + shifted[j + 1];
  std::array<E, N> half;
  double power = 1;
  for (std::size_t j = 0; j < N; ++j, power *= 2) half[N - 1 - j] = E(power) * shifted[j];
  return half;
}

/// 2^n times the polynomial at (1 + t) / 2.
template <class E, std::size_t N>
std::array<E, N> right_half(std::array<E, N> p) {
  std::reverse(p.begin(), p.end());
  p = left_half(p);
  std::reverse(p.begin(), p.end());
  return p;
}

/// The polynomial on a part of [0, 1], times a power of two.
template <class E, std::size_t N>
std::array<E, N> restricted(std::array<E, N> p, const DyadicInterval& part) {
  for (int k = part.depth; k-- > 0;) p = (part.index >> k & 1) == 0 ? left_half(p) : right_half(p);
  return p;
}

}  // namespace tensortopo
