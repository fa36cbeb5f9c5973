// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace tensortopo {

/// A symmetric matrix of order `Order`, full.
template <class Scalar, std::size_t Order>
using SquareMatrix = std::array<std::array<Scalar, Order>, Order>;

/// Without one row and one column.
template <class Scalar, std::size_t Order>
SquareMatrix<Scalar, Order - 1> minor_matrix(const SquareMatrix<Scalar, Order>& a, std::size_t row,
                                             std::size_t column) {
  SquareMatrix<Scalar, Order - 1> result;
  for (std::size_t i = 0; i + 1 < Order; ++i)
    for (std::size_t j = 0; j + 1 < Order; ++j) result[i][j] = a[i + (i >= row)][j + (j >= column)];
  return result;
}

template <class Scalar, std::size_t Order>
Scalar determinant_of(const SquareMatrix<Scalar, Order>& a);

/// The cofactors of the last row c: a c = det(a) times the last unit vector.
template <class Scalar, std::size_t Order>
std::array<Scalar, Order> last_cofactors(const SquareMatrix<Scalar, Order>& a) {
  std::array<Scalar, Order> result;
  for (std::size_t j = 0; j < Order; ++j) {
    result[j] = determinant_of<Scalar, Order - 1>(minor_matrix<Scalar, Order>(a, Order - 1, j));
    if ((Order - 1 + j) % 2 != 0) result[j] = -result[j];
  }
  return result;
}

template <class Scalar, std::size_t Order>
Scalar determinant_of(const SquareMatrix<Scalar, Order>& a) {
  if constexpr (Order == 1) {
    return a[0][0];
  } else {
    const auto c = last_cofactors<Scalar, Order>(a);
    Scalar sum = a[Order - 1][0] * c[0];
    for (std::size_t j = 1; j < Order; ++j) sum = sum + a[Order - 1][j] * c[j];
    return sum;
  }
}

/// What Keller's criterion says of the form x^T a x on the open simplex {x > 0}, given that it is
/// positive on all of the simplex's boundary: it is positive inside too unless the cofactors of the
/// last row are all positive and the determinant is not. The cofactors are then a place where the
/// form is <= 0.
///
/// Source    Keller's theorem, in K. P. Hadeler, On copositive matrices, Linear Algebra and its
///           Applications 49 (1983): a symmetric matrix is strictly copositive if and only if each
///           principal submatrix for which the cofactors of the last row are all positive has a
///           positive determinant.
/// Requires  exact arithmetic; every proper principal submatrix strictly copositive.
template <class Scalar, std::size_t Order>
bool is_positive_inside(const SquareMatrix<Scalar, Order>& a,
                        const std::array<Scalar, Order>& cofactors) {
  for (const Scalar& c : cofactors)
    if (!(c > 0)) return true;
  Scalar determinant = a[Order - 1][0] * cofactors[0];
  for (std::size_t j = 1; j < Order; ++j)
    determinant = determinant + a[Order - 1][j] * cofactors[j];
  return determinant > 0;
}

}  // namespace tensortopo
