// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The two invariants of a linear tensor field on a simplex, as polynomials in its weights.
#pragma once

#include "polynomial.hpp"

namespace certificate {

/// A trace-free symmetric matrix M: 11, 22, 33, 23, 13, 12. It stands for a tensor up to a
/// positive factor.
template <class N>
using Tensor = std::array<N, 6>;

/// The cofactors of a M, and of all mixed terms in those of M + K.
template <class N>
Tensor<N> cofactors(const Tensor<N>& m) {
  return {N(m[1] * m[2] - m[3] * m[3]), N(m[0] * m[2] - m[4] * m[4]),
          N(m[0] * m[1] - m[5] * m[5]), N(m[4] * m[5] - m[0] * m[3]),
          N(m[3] * m[5] - m[1] * m[4]), N(m[3] * m[4] - m[2] * m[5])};
}
template <class N>
Tensor<N> mixed_cofactors(const Tensor<N>& m, const Tensor<N>& k) {
  const auto mixed = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return N(N(m[a] * k[b] + k[a] * m[b]) - N(m[c] * k[d] + k[c] * m[d]));
  };
  return {mixed(1, 2, 3, 3), mixed(0, 2, 4, 4), mixed(0, 1, 5, 5),
          mixed(4, 5, 0, 3), mixed(3, 5, 1, 4), mixed(3, 4, 2, 5)};
}

/// tr(M K).
template <class N>
N trace(const Tensor<N>& m, const Tensor<N>& k) {
  const N diagonal = m[0] * k[0] + m[1] * k[1] + m[2] * k[2];
  const N rest = m[3] * k[3] + m[4] * k[4] + m[5] * k[5];
  return N(diagonal + rest + rest);
}

/// P = tr(M^2) and Q = det(M) for M the sum of weights times the tensors of the V vertices. The
/// mode is sqrt(54) Q / P^(3/2), that of any positive multiple of M.
template <class N, std::size_t V>
struct Forms {
  Polynomial<N, V, 2> p;
  Polynomial<N, V, 3> q;

  explicit Forms(const std::array<const Tensor<N>*, V>& m) {
    static constexpr auto two = detail::pair_table<V>();
    static constexpr auto three = detail::triple_table<V>();
    for (std::size_t i = 0; i < V; ++i) {
      const Tensor<N> c = cofactors(*m[i]);
      const Tensor<N>& a = *m[i];
      for (std::size_t j = 0; j < V; ++j)
        if (j != i) q.coefficients[three[i][i][j]] = trace(c, *m[j]);
      q.coefficients[three[i][i][i]] = N(a[0] * c[0] + a[5] * c[5] + a[4] * c[4]);
      p.coefficients[two[i][i]] = trace(a, a);
      for (std::size_t j = i + 1; j < V; ++j) {
        const N half = trace(a, *m[j]);
        p.coefficients[two[i][j]] = N(half + half);
        if (j + 1 == V) continue;
        const Tensor<N> both = mixed_cofactors(a, *m[j]);
        for (std::size_t k = j + 1; k < V; ++k) q.coefficients[three[i][j][k]] = trace(both, *m[k]);
      }
    }
  }
};

/// 2 P dQ - 3 Q dP along d: of the sign of the mode's derivative, if P > 0.
template <class N, std::size_t V>
Polynomial<N, V, 4> increase(const Forms<N, V>& f, const std::array<int, V>& d) {
  Polynomial<N, V, 2> dq;
  Polynomial<N, V, 1> dp;
  for (std::size_t j = 0; j < V; ++j) {
    add_derivative(f.q, j, N(d[j]), dq);
    add_derivative(f.p, j, N(d[j]), dp);
  }
  return combination(N(2), f.p * dq, N(3), f.q * dp);
}

}  // namespace certificate
