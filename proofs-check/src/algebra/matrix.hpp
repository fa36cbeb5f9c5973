// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "algebra/polynomial.hpp"

namespace proofs {

/// A matrix of polynomials, of N rows and columns.
template <std::size_t N>
using Matrix = std::array<std::array<Polynomial, N>, N>;
using Matrix2 = Matrix<2>;
using Matrix3 = Matrix<3>;
template <std::size_t N>
using Vector = std::array<Polynomial, N>;
using Vector2 = Vector<2>;
using Vector3 = Vector<3>;

template <std::size_t N>
Matrix<N> operator*(const Matrix<N>& m, const Matrix<N>& n) {
  Matrix<N> result;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j)
      for (std::size_t k = 0; k < N; ++k) result[i][j] += m[i][k] * n[k][j];
  return result;
}

template <std::size_t N>
Vector<N> operator*(const Matrix<N>& m, const Vector<N>& v) {
  Vector<N> result;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j) result[i] += m[i][j] * v[j];
  return result;
}

template <std::size_t N>
Vector<N> operator*(const Polynomial& factor, Vector<N> v) {
  for (Polynomial& entry : v) entry = factor * entry;
  return v;
}

template <std::size_t N>
Vector<N> operator-(Vector<N> u, const Vector<N>& v) {
  for (std::size_t i = 0; i < N; ++i) u[i] -= v[i];
  return u;
}

template <std::size_t N>
Matrix<N> operator-(Matrix<N> m, const Matrix<N>& n) {
  for (std::size_t i = 0; i < N; ++i) m[i] = m[i] - n[i];
  return m;
}

template <std::size_t N>
Matrix<N> transpose(const Matrix<N>& m) {
  Matrix<N> result;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j) result[i][j] = m[j][i];
  return result;
}

/// A multiple of the identity.
template <std::size_t N>
Matrix<N> isotropic(const Polynomial& factor) {
  Matrix<N> result;
  for (std::size_t i = 0; i < N; ++i) result[i][i] = factor;
  return result;
}

/// The entries one after the other.
template <std::size_t N>
std::vector<Polynomial> entries(const Matrix<N>& m) {
  std::vector<Polynomial> all;
  for (const auto& row : m) all.insert(all.end(), row.begin(), row.end());
  return all;
}

template <std::size_t N>
Polynomial trace(const Matrix<N>& m) {
  Polynomial sum;
  for (std::size_t i = 0; i < N; ++i) sum += m[i][i];
  return sum;
}

/// Sum of the products of entries in the same place.
template <std::size_t N>
Polynomial inner(const Matrix<N>& m, const Matrix<N>& n) {
  Polynomial sum;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j) sum += m[i][j] * n[i][j];
  return sum;
}

inline Polynomial determinant(const Matrix2& m) { return m[0][0] * m[1][1] - m[0][1] * m[1][0]; }

inline Matrix2 adjugate(const Matrix2& m) { return {{{m[1][1], -m[0][1]}, {-m[1][0], m[0][0]}}}; }

/// Transposed matrix of cofactors.
inline Matrix3 adjugate(const Matrix3& m) {
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      result[j][i] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
    }
  return result;
}

inline Polynomial determinant(const Matrix3& m) {
  const Matrix3 a = adjugate(m);
  return m[0][0] * a[0][0] + m[0][1] * a[1][0] + m[0][2] * a[2][0];
}

/// v.M v
inline Polynomial quadratic_form(const Matrix3& m, const Vector3& v) {
  Polynomial sum;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sum += v[i] * m[i][j] * v[j];
  return sum;
}

template <std::size_t N>
Polynomial dot(const Vector<N>& u, const Vector<N>& v) {
  Polynomial sum;
  for (std::size_t i = 0; i < N; ++i) sum += u[i] * v[i];
  return sum;
}

inline Vector3 cross(const Vector3& u, const Vector3& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

inline Matrix3 symmetric(const Polynomial& xx, const Polynomial& yy, const Polynomial& zz,
                         const Polynomial& xy, const Polynomial& yz, const Polynomial& xz) {
  return {{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
}

inline Matrix3 diagonal(const Vector3& d) { return symmetric(d[0], d[1], d[2], {}, {}, {}); }

}  // namespace proofs
