// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "tensortopo/extract/curve_points.hpp"
#include "tensortopo/tensor/deviator.hpp"

/// \file
/// The degenerate tensors e e^T - (|e|^2 / 3) I of a linear field, through quadratic forms in e.
///
/// In the coordinates t = (a, b, xy, yz, xz) of deviators, a linear functional of e e^T is a
/// quadratic form in e with trace zero. A degenerate tensor is in the field iff the functionals
/// that vanish on the field do so at e; its weights are functionals too. Everything here is
/// polynomial in the input: minors, no division.

namespace tensortopo {

template <class E>
using Covector = std::array<E, 5>;

/// The deviator of an input tensor times its power of two.
template <class E>
Deviator<E> exact_deviator(const ScaledTensor& t) {
  const int half = t.exponent / 2;
  const E first(std::ldexp(1.0, half)), second(std::ldexp(1.0, t.exponent - half));
  const auto scaled = [&](const E& x) { return E((x * first) * second); };
  const auto& s = t.tensor;
  return {scaled(E(s.xx) - E(s.yy)), scaled(E(s.yy) - E(s.zz)), scaled(E(s.xy)), scaled(E(s.yz)),
          scaled(E(s.xz))};
}

template <class E, std::size_t Vertices>
std::array<Covector<E>, Vertices> coordinate_rows(
    const std::array<ScaledTensor, Vertices>& tensors) {
  std::array<Covector<E>, Vertices> rows;
  for (std::size_t i = 0; i < Vertices; ++i) {
    const auto d = exact_deviator<E>(tensors[i]);
    rows[i] = {d.a, d.b, d.xy, d.yz, d.xz};
  }
  return rows;
}

/// Twice the covector at e e^T, as a form in e.
template <class E>
SymmetricTensor<E> form_of(const Covector<E>& n) {
  return {n[0] + n[0], n[1] - n[0] + (n[1] - n[0]), -(n[1] + n[1]), n[2], n[3], n[4]};
}

template <class E>
E polar(const SymmetricTensor<E>& form, const Vector3<E>& x, const Vector3<E>& y) {
  return dot(x, form * y);
}

template <class E>
E determinant_of(const std::array<std::array<E, 2>, 2>& m) {
  return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}

/// The matrix without one row and one column.
template <class E, std::size_t N>
std::array<std::array<E, N - 1>, N - 1> without(const std::array<std::array<E, N>, N>& m,
                                                std::size_t row, std::size_t column) {
  std::array<std::array<E, N - 1>, N - 1> rest;
  for (std::size_t i = 0; i + 1 < N; ++i)
    for (std::size_t j = 0; j + 1 < N; ++j)
      rest[i][j] = m[i < row ? i : i + 1][j < column ? j : j + 1];
  return rest;
}

template <class E, std::size_t N>
requires(N > 2) E determinant_of(const std::array<std::array<E, N>, N>& m) {
  E sum = m[0][0] * determinant_of(without(m, 0, 0));
  for (std::size_t j = 1; j < N; ++j) {
    const E term = m[0][j] * determinant_of(without(m, 0, j));
    sum = j % 2 == 0 ? E(sum + term) : E(sum - term);
  }
  return sum;
}

/// The forms of a field on `Vertices` vertices.
template <class E, std::size_t Vertices>
struct FieldForms {
  /// At a degenerate tensor of the field these are its weights times twice `determinant`.
  std::array<SymmetricTensor<E>, Vertices> weight;
  /// Zero exactly at the directions e of the degenerate tensors of the field.
  std::array<SymmetricTensor<E>, 5 - Vertices> across;
  /// The minor of the columns kept.
  E determinant;
};

/// By Cramer's rule with the columns given: the first `Vertices` of them must have a minor that is
/// not zero.
template <class E, std::size_t Vertices>
FieldForms<E, Vertices> field_forms(const std::array<Covector<E>, Vertices>& rows,
                                    const std::array<std::size_t, 5>& columns) {
  FieldForms<E, Vertices> forms;
  std::array<std::array<E, Vertices>, Vertices> kept;
  for (std::size_t i = 0; i < Vertices; ++i)
    for (std::size_t j = 0; j < Vertices; ++j) kept[i][j] = rows[i][columns[j]];
  forms.determinant = determinant_of(kept);
  std::array<Covector<E>, 5 - Vertices> across;
  for (auto& n : across) n.fill(E(0.0));
  for (std::size_t k = Vertices; k < 5; ++k) across[k - Vertices][columns[k]] = forms.determinant;
  for (std::size_t i = 0; i < Vertices; ++i) {
    Covector<E> weight;
    weight.fill(E(0.0));
    for (std::size_t j = 0; j < Vertices; ++j) {
      const E cofactor = determinant_of(without(kept, i, j));
      weight[columns[j]] = (i + j) % 2 == 0 ? cofactor : E(-cofactor);
    }
    forms.weight[i] = form_of(weight);
    for (std::size_t k = Vertices; k < 5; ++k)
      for (std::size_t j = 0; j < Vertices; ++j) {
        auto& entry = across[k - Vertices][columns[j]];
        entry = entry - weight[columns[j]] * rows[i][columns[k]];
      }
  }
  for (std::size_t k = 0; k < across.size(); ++k) forms.across[k] = form_of(across[k]);
  return forms;
}

/// Calls `take` with each way to keep `Vertices` columns, in order: those kept, then the others.
template <std::size_t Vertices, class Take>
void for_each_choice(const Take& take) {
  for (unsigned kept = 0; kept < 32; ++kept) {
    std::array<std::size_t, 5> columns{};
    std::size_t first = 0, last = 5;
    for (std::size_t c = 5; c-- > 0;)
      if ((kept >> c & 1) == 0 && last > 0) columns[--last] = c;
    if (last != Vertices) continue;
    for (std::size_t c = 0; c < 5; ++c)
      if (kept >> c & 1) columns[first++] = c;
    take(columns);
  }
}

/// The columns with the largest minor, all entries being of order one.
template <class E, std::size_t Vertices>
std::array<std::size_t, 5> best_columns(const std::array<Covector<E>, Vertices>& rows) {
  std::array<std::size_t, 5> best{0, 1, 2, 3, 4};
  E largest(-1.0);
  for_each_choice<Vertices>([&](const std::array<std::size_t, 5>& columns) {
    std::array<std::array<E, Vertices>, Vertices> kept;
    for (std::size_t i = 0; i < Vertices; ++i)
      for (std::size_t j = 0; j < Vertices; ++j) kept[i][j] = rows[i][columns[j]];
    E minor = determinant_of(kept);
    if (minor < E(0.0)) minor = -minor;
    if (minor > largest) largest = minor, best = columns;
  });
  return best;
}

/// The coefficients of det(x M + y N).
template <class E>
std::array<E, 4> pencil_cubic(const SymmetricTensor<E>& m, const SymmetricTensor<E>& n) {
  const auto cofactors = [](const SymmetricTensor<E>& t) {
    return SymmetricTensor<E>{t.yy * t.zz - t.yz * t.yz, t.xx * t.zz - t.xz * t.xz,
                              t.xx * t.yy - t.xy * t.xy, t.xz * t.yz - t.xy * t.zz,
                              t.xy * t.xz - t.xx * t.yz, t.xy * t.yz - t.xz * t.yy};
  };
  const auto product = [](const SymmetricTensor<E>& s, const SymmetricTensor<E>& t) {
    const E mixed = s.xy * t.xy + s.yz * t.yz + s.xz * t.xz;
    return E(s.xx * t.xx + s.yy * t.yy + s.zz * t.zz + (mixed + mixed));
  };
  return {determinant(m), product(cofactors(m), n), product(m, cofactors(n)), determinant(n)};
}

/// Positive if the cubic a x^3 + b x^2 y + c x y^2 + d y^3 has three real zeros, negative if one,
/// zero if two coincide.
template <class E>
E cubic_discriminant(const std::array<E, 4>& f) {
  const auto& [a, b, c, d] = f;
  const E bc = b * c, ad = a * d;
  return bc * bc - E(4.0) * (a * c * c * c + b * b * b * d) + ad * (E(18.0) * bc - E(27.0) * ad);
}

}  // namespace tensortopo
