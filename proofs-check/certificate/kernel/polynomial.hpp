// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Homogeneous polynomials in the weights of a simplex's vertices, by their coefficients.
#pragma once

#include <array>
#include <cstddef>

#include "ball.hpp"

namespace certificate {

/// The exponents of all monomials of degree D in V variables.
template <std::size_t V, std::size_t D>
struct Monomials {
  using Exponents = std::array<std::size_t, V>;
  static constexpr std::size_t kCount = [] {
    std::size_t n = 1;
    for (std::size_t i = 1; i < V; ++i) n = n * (D + i) / i;
    return n;
  }();

  static constexpr std::array<Exponents, kCount> kTable = [] {
    std::array<Exponents, kCount> result{};
    std::size_t n = 0, codes = 1;
    for (std::size_t i = 0; i < V; ++i) codes *= D + 1;
    for (std::size_t code = 0; code < codes; ++code) {
      Exponents e{};
      std::size_t sum = 0, rest = code;
      for (std::size_t i = 0; i < V; ++i, rest /= D + 1) sum += e[i] = rest % (D + 1);
      if (sum == D) result[n++] = e;
    }
    return result;
  }();

  static constexpr std::size_t index(const Exponents& e) {
    std::size_t n = 0;
    while (n < kCount && kTable[n] != e) ++n;
    return n;
  }
};

template <class N, std::size_t V, std::size_t D>
struct Polynomial {
  static constexpr std::size_t kCount = Monomials<V, D>::kCount;
  std::array<N, kCount> coefficients{};
};

/// Have all coefficients this sign, and so all values?
template <class N, std::size_t V, std::size_t D>
Answer have_sign(const Polynomial<N, V, D>& p, int sign, Zero zero) {
  Answer result = Answer::yes;
  for (const N& x : p.coefficients) {
    const Answer one = has_sign(x, sign, zero);
    if (one == Answer::no) return one;
    if (one == Answer::unsure) result = one;
  }
  return result;
}

template <class N, std::size_t V, std::size_t D>
Answer is_zero(const Polynomial<N, V, D>& p) {
  return both(have_sign(p, 1, Zero::will_do), [&] { return have_sign(p, -1, Zero::will_do); });
}

template <std::size_t V, std::size_t D, std::size_t E>
constexpr auto product_table() {
  constexpr auto a = Monomials<V, D>::kTable;
  constexpr auto b = Monomials<V, E>::kTable;
  std::array<std::array<unsigned char, b.size()>, a.size()> result{};
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      typename Monomials<V, D>::Exponents sum{};
      for (std::size_t k = 0; k < V; ++k) sum[k] = a[i][k] + b[j][k];
      result[i][j] = static_cast<unsigned char>(Monomials<V, D + E>::index(sum));
    }
  }
  return result;
}

template <class N, std::size_t V, std::size_t D, std::size_t E>
Polynomial<N, V, D + E> operator*(const Polynomial<N, V, D>& a, const Polynomial<N, V, E>& b) {
  static constexpr auto table = product_table<V, D, E>();
  Polynomial<N, V, D + E> result;
  for (std::size_t i = 0; i < a.kCount; ++i)
    for (std::size_t j = 0; j < b.kCount; ++j)
      result.coefficients[table[i][j]] += N(a.coefficients[i] * b.coefficients[j]);
  return result;
}

/// a p + b q.
template <class N, std::size_t V, std::size_t D>
Polynomial<N, V, D> combination(const N& a, const Polynomial<N, V, D>& p, const N& b,
                                const Polynomial<N, V, D>& q) {
  Polynomial<N, V, D> result;
  for (std::size_t i = 0; i < p.kCount; ++i)
    result.coefficients[i] = a * p.coefficients[i] + b * q.coefficients[i];
  return result;
}
template <class N, std::size_t V, std::size_t D>
Polynomial<N, V, D> operator-(Polynomial<N, V, D> p, const Polynomial<N, V, D>& q) {
  for (std::size_t i = 0; i < p.kCount; ++i) p.coefficients[i] -= q.coefficients[i];
  return p;
}

/// The derivative along d.
template <class N, std::size_t V, std::size_t D>
Polynomial<N, V, D - 1> derivative(const Polynomial<N, V, D>& p, const std::array<int, V>& d) {
  static constexpr auto exponents = Monomials<V, D>::kTable;
  static constexpr auto places = product_table<V, D - 1, 1>();
  Polynomial<N, V, D - 1> result;
  for (std::size_t i = 0; i < result.kCount; ++i)
    for (std::size_t j = 0; j < V; ++j) {
      const std::size_t from = places[i][j];
      if (const int factor = static_cast<int>(exponents[from][j]) * d[j]; factor != 0)
        result.coefficients[i] += N(N(factor) * p.coefficients[from]);
    }
  return result;
}

}  // namespace certificate
