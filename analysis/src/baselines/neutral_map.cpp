// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "baselines/neutral_map.hpp"

namespace tensortopo::baselines {

namespace {

using Vector = Vector3<double>;

double det(const Vector& a, const Vector& b, const Vector& c) { return dot(cross(a, b), c); }

/// The columns of the minor that leaves out column i, in an order that gives it its sign.
constexpr std::array<std::array<std::size_t, 3>, 4> kMinors{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

}  // namespace

NeutralMap::NeutralMap(const std::array<Deviator<double>, 4>& tensors) {
  for (std::size_t i = 0; i < 4; ++i) tensors_[i] = (1.0 / 3) * thrice(tensors[i]);
}

std::array<double, 4> NeutralMap::weights(const Vector& v) const {
  std::array<Vector, 4> column;
  for (std::size_t i = 0; i < 4; ++i) column[i] = tensors_[i] * v;
  std::array<double, 4> b;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [j, k, l] = kMinors[i];
    b[i] = det(column[j], column[k], column[l]);
  }
  return b;
}

std::array<double, 4> NeutralMap::slopes(const Vector& v, const Vector& d) const {
  std::array<Vector, 4> at, along;
  for (std::size_t i = 0; i < 4; ++i) at[i] = tensors_[i] * v, along[i] = tensors_[i] * d;
  std::array<double, 4> b;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [j, k, l] = kMinors[i];
    b[i] = det(along[j], at[k], at[l]) + det(at[j], along[k], at[l]) + det(at[j], at[k], along[l]);
  }
  return b;
}

std::array<double, 4> NeutralMap::squares(const Vector& v) const {
  std::array<double, 4> s;
  for (std::size_t i = 0; i < 4; ++i) s[i] = dot(v, tensors_[i] * v);
  return s;
}

std::array<Cubic, 4> NeutralMap::on(const std::array<Vector, 3>& corners) const {
  std::array<std::array<Vector, 3>, 4> column;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t a = 0; a < 3; ++a) column[i][a] = tensors_[i] * corners[a];
  std::array<Cubic, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto &p = column[kMinors[i][0]], &q = column[kMinors[i][1]], &r = column[kMinors[i][2]];
    // Bernstein coefficients are values of the polar form, which is the mean over the orders.
    const auto polar = [&](std::size_t a, std::size_t b, std::size_t c) {
      return (det(p[a], q[b], r[c]) + det(p[b], q[c], r[a]) + det(p[c], q[a], r[b])) / 3;
    };
    auto& c = result[i];
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t j = a == 1 ? 3 : 0, k = a == 2 ? 3 : 0;
      c[cubic_place(j, k)] = det(p[a], q[a], r[a]);
    }
    c[cubic_place(1, 0)] = polar(0, 0, 1);
    c[cubic_place(2, 0)] = polar(0, 1, 1);
    c[cubic_place(0, 1)] = polar(0, 0, 2);
    c[cubic_place(0, 2)] = polar(0, 2, 2);
    c[cubic_place(2, 1)] = polar(1, 1, 2);
    c[cubic_place(1, 2)] = polar(1, 2, 2);
    c[cubic_place(1, 1)] = (polar(0, 1, 2) + polar(0, 2, 1)) / 2;
  }
  return result;
}

Cubic turned(const Cubic& cubic) {
  Cubic result;
  for (std::size_t k = 0; k <= 3; ++k)
    for (std::size_t j = 0; j + k <= 3; ++j)
      result[cubic_place(k, 3 - j - k)] = cubic[cubic_place(j, k)];
  return result;
}

std::array<Cubic, 2> halves(const Cubic& cubic) {
  std::array<Cubic, 2> result;
  for (std::size_t k = 0; k <= 3; ++k) {
    // De Casteljau's scheme on the row of degree 3 - k along the edge from a to b.
    const std::size_t degree = 3 - k;
    std::array<double, 4> row{};
    for (std::size_t j = 0; j <= degree; ++j) row[j] = cubic[cubic_place(j, k)];
    for (std::size_t j = 0; j <= degree; ++j) {
      // (a, m, c) with exponents (degree - j, j, k), as (c, a, m).
      result[0][cubic_place(degree - j, j)] = row[0];
      // (m, b, c) with exponents (j, degree - j, k), as (b, c, m).
      result[1][cubic_place(k, j)] = row[degree - j];
      for (std::size_t n = 0; n + j < degree; ++n) row[n] = 0.5 * (row[n] + row[n + 1]);
    }
  }
  return result;
}

}  // namespace tensortopo::baselines
