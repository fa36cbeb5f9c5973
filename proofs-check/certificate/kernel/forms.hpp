// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Invariants of a linear tensor field on a simplex, as polynomials in its weights.
#pragma once

#include <algorithm>
#include <cmath>

#include "ball.hpp"
#include "polynomial.hpp"

namespace certificate {

/// A trace-free symmetric matrix M: 11, 22, 33, 23, 13, 12; a multiple t of the trace, and h of the
/// number one, which are 0 where levels do not depend on them. All of it is known up to a positive
/// factor: on a simplex whose corners are multiplied each by its own, a form has the same signs.
template <class N>
using Tensor = std::array<N, 8>;

/// Divides by a power of 2 so that the largest entry is from 1/2 to 1: subdivisions rely on tensors
/// of similar size.
/// @return the exponent
inline int scale_to_one(Tensor<Ball>& m) {
  double size = 0;
  for (const Ball& x : m) size = std::max(size, std::abs(x.value));
  int exponent = 0;
  if (size > 0 && size < HUGE_VAL) std::frexp(size, &exponent);
  const Ball factor(std::ldexp(1.0, -exponent), 0);
  for (Ball& x : m) x = x * factor;
  return exponent;
}

/// tr(M K).
template <class N>
N trace(const Tensor<N>& m, const Tensor<N>& k) {
  const N diagonal = m[0] * k[0] + m[1] * k[1] + m[2] * k[2];
  const N rest = m[3] * k[3] + m[4] * k[4] + m[5] * k[5];
  return N(diagonal + rest + rest);
}

/// A measure for angles.
template <class N>
N product(const Tensor<N>& m, const Tensor<N>& k) {
  return N(trace(m, k) + m[6] * k[6] + m[7] * k[7]);
}

/// The quadratic form of a bilinear one.
template <class N, std::size_t V, class Bilinear>
Polynomial<N, V, 2> quadratic(const std::array<const Tensor<N>*, V>& m, const Bilinear& product) {
  static constexpr auto places = product_table<V, 1, 1>();
  Polynomial<N, V, 2> result;
  for (std::size_t i = 0; i < V; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      result.coefficients[places[i][j]] = N(N(i == j ? 1 : 2) * product(*m[i], *m[j]));
  return result;
}

/// P = tr(M^2) and Q = det(M) for M the sum of weights times the tensors of the V vertices. The
/// mode is sqrt(54) Q / P^(3/2), that of any positive multiple of M.
template <class N, std::size_t V>
struct Forms {
  Polynomial<N, V, 2> p;
  Polynomial<N, V, 3> q;

  Forms() = default;
  explicit Forms(const std::array<const Tensor<N>*, V>& m) {
    std::array<Polynomial<N, V, 1>, 6> x;
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t i = 0; i < V; ++i) x[k].coefficients[i] = (*m[i])[k];
    p = quadratic<N, V>(m, trace<N>);
    q = x[0] * (x[1] * x[2] - x[3] * x[3]) - x[5] * (x[2] * x[5] - x[3] * x[4]) -
        x[4] * (x[1] * x[4] - x[3] * x[5]);
  }
};

/// 2 P dQ - 3 Q dP along d: of the sign of the mode's derivative, if P > 0.
template <class N, std::size_t V>
Polynomial<N, V, 4> increase(const Forms<N, V>& f, const std::array<int, V>& d) {
  return combination(N(2), f.p * derivative(f.q, d), N(-3), f.q * derivative(f.p, d));
}

}  // namespace certificate
