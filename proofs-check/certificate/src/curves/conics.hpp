// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The degenerate tensors of a linear field, as points of conics.
//
// A trace-free tensor with two equal eigenvalues is s (e e^T - |e|^2/3) for a vector e and s = 1
// (linear, mode 1) or s = -1 (planar, mode -1). A linear functional of tensors is at e e^T -
// |e|^2/3 a quadratic form in e. So those in the span of some tensors are where the functionals
// that vanish on the span do, and their weights are functionals as well.
#pragma once

#include <array>
#include <cstddef>

#include "forms.hpp"

namespace certificate {

template <class N>
using Vector3 = std::array<N, 3>;

template <class N>
Vector3<N> cross(const Vector3<N>& a, const Vector3<N>& b) {
  return {N(a[1] * b[2] - a[2] * b[1]), N(a[2] * b[0] - a[0] * b[2]), N(a[0] * b[1] - a[1] * b[0])};
}
template <class N>
N dot(const Vector3<N>& a, const Vector3<N>& b) {
  return N(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/// A quadratic form in e, by its matrix: 11, 22, 33, 23, 13, 12.
template <class N>
struct Conic {
  std::array<N, 6> m{};

  Vector3<N> times(const Vector3<N>& e) const {
    return {N(m[0] * e[0] + m[5] * e[1] + m[4] * e[2]), N(m[5] * e[0] + m[1] * e[1] + m[3] * e[2]),
            N(m[4] * e[0] + m[3] * e[1] + m[2] * e[2])};
  }
  /// The bilinear form.
  N operator()(const Vector3<N>& a, const Vector3<N>& b) const { return dot(a, times(b)); }
  N determinant() const {
    return N(m[0] * (m[1] * m[2] - m[3] * m[3]) + m[5] * (m[3] * m[4] - m[5] * m[2]) +
             m[4] * (m[5] * m[3] - m[1] * m[4]));
  }
};

template <class N, std::size_t K>
N determinant_of(const std::array<std::array<N, K>, K>& rows);

/// The determinant without a row and a column, with its sign.
template <class N, std::size_t K>
N cofactor(const std::array<std::array<N, K>, K>& rows, std::size_t row, std::size_t column) {
  std::array<std::array<N, K - 1>, K - 1> rest;
  for (std::size_t i = 0; i + 1 < K; ++i)
    for (std::size_t j = 0; j + 1 < K; ++j) rest[i][j] = rows[i + (i >= row)][j + (j >= column)];
  const N minor = determinant_of(rest);
  return (row + column) % 2 == 0 ? minor : N(N(-1) * minor);
}

template <class N, std::size_t K>
N determinant_of(const std::array<std::array<N, K>, K>& rows) {
  if constexpr (K == 2) {
    return N(rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]);
  } else {
    N sum(0);
    for (std::size_t j = 0; j < K; ++j) sum += N(rows[0][j] * cofactor(rows, 0, j));
    return sum;
  }
}

/// The coordinates of trace-free tensors.
template <class N>
using Row = std::array<N, 5>;
template <class N>
Row<N> row_of(const Tensor<N>& t) {
  return {t[0], t[1], t[3], t[4], t[5]};
}
/// Six times a functional of these at e e^T - |e|^2/3.
template <class N>
Conic<N> conic_of(const Row<N>& n) {
  const N two(2), three(3), four(4);
  return {{N(four * n[0] - two * n[1]), N(four * n[1] - two * n[0]), N(N(-2) * (n[0] + n[1])),
           N(three * n[2]), N(three * n[3]), N(three * n[4])}};
}

/// An order of the coordinates such that the first V of V tensors have a large minor.
template <std::size_t V>
std::array<std::size_t, 5> likely_columns(const std::array<Row<double>, V>& rows) {
  std::array<std::size_t, 5> best{};
  double largest = -1;
  for (unsigned kept = 0; kept < 32; ++kept) {
    std::array<std::size_t, 5> order{};
    std::size_t first = 0, last = 5;
    for (std::size_t c = 0; c < 5 && last > 0; ++c)
      if ((kept >> c & 1U) != 0 && first < 5)
        order[first++] = c;
      else
        order[--last] = c;
    if (first != V) continue;
    std::array<std::array<double, V>, V> minor;
    for (std::size_t i = 0; i < V; ++i)
      for (std::size_t j = 0; j < V; ++j) minor[i][j] = rows[i][order[j]];
    const double size = std::abs(determinant_of(minor));
    if (size > largest) largest = size, best = order;
  }
  return best;
}

/// Of V tensors, if `minor` is not 0.
template <class N, std::size_t V>
struct SpanForms {
  N minor;  ///< of the first columns
  /// At a degenerate tensor s (e e^T - |e|^2/3) that is the sum of w_i times the tensors these are
  /// 6 s minor w_i.
  std::array<Conic<N>, V> weight;
  /// Independent, and all zero at e exactly if the tensor is in the span.
  std::array<Conic<N>, 5 - V> across;

  /// By Cramer's rule.
  SpanForms(const std::array<Row<N>, V>& rows, const std::array<std::size_t, 5>& columns) {
    std::array<std::array<N, V>, V> kept;
    for (std::size_t i = 0; i < V; ++i)
      for (std::size_t j = 0; j < V; ++j) kept[i][j] = rows[i][columns[j]];
    minor = determinant_of(kept);
    std::array<Row<N>, 5 - V> zero{};
    for (std::size_t k = V; k < 5; ++k) zero[k - V][columns[k]] = minor;
    for (std::size_t i = 0; i < V; ++i) {
      Row<N> n{};
      for (std::size_t j = 0; j < V; ++j) {
        n[columns[j]] = cofactor(kept, i, j);
        for (std::size_t k = V; k < 5; ++k)
          zero[k - V][columns[j]] -= N(rows[i][columns[k]] * n[columns[j]]);
      }
      weight[i] = conic_of(n);
    }
    for (std::size_t k = 0; k < zero.size(); ++k) across[k] = conic_of(zero[k]);
  }
};

}  // namespace certificate
