// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/critical_simplices.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "tensortopo/quadric/copositive.hpp"

namespace tensortopo {

namespace {

/// Whether there is certainly a direction d with A d > 0, or A has entries of one sign only. The
/// form's entries have errors below kError, after division by the sizes.
template <std::size_t Order>
bool is_clearly_regular(const SquareMatrix<double, Order>& a) {
  constexpr double kError = QuadricForm::kError;
  double least = a[0][0], most = a[0][0];
  for (const auto& row : a)
    for (const double x : row) least = std::min(least, x), most = std::max(most, x);
  if (least > kError || most < -kError) return true;
  // A perceptron over the rows.
  std::array<double, Order> d{};
  for (const auto& row : a)
    for (std::size_t j = 0; j < Order; ++j) d[j] += row[j];
  constexpr int kSteps = 30;
  for (int step = 0; step < kSteps; ++step) {
    double length = 0, worst = HUGE_VAL;
    for (const double x : d) length += std::abs(x);
    const std::array<double, Order>* lowest = nullptr;
    for (const auto& row : a) {
      double product = 0, square = 0;
      for (std::size_t j = 0; j < Order; ++j) product += row[j] * d[j], square += row[j] * row[j];
      if (product / std::sqrt(square) < worst) lowest = &row, worst = product / std::sqrt(square);
    }
    if (lowest == nullptr || !(length < HUGE_VAL)) return false;
    double square = 0, product = 0;
    for (std::size_t j = 0; j < Order; ++j) {
      product += (*lowest)[j] * d[j];
      square += (*lowest)[j] * (*lowest)[j];
    }
    const bool all = std::all_of(a.begin(), a.end(), [&](const auto& row) {
      double sum = 0;
      for (std::size_t j = 0; j < Order; ++j) sum += row[j] * d[j];
      return sum > 2 * kError * length;
    });
    if (all) return true;
    const double push = (-product + 0.05 * length * std::sqrt(square)) / square;
    for (std::size_t j = 0; j < Order; ++j) d[j] += push * (*lowest)[j];
  }
  return false;
}

/// Whether A b = 0 for b > 0, or in an edge b >= 0 but 0; and not all of it is below or on the
/// level.
template <std::size_t Order>
bool is_critical(const QuadricForm& form, const std::array<std::size_t, Order>& corners) {
  SquareMatrix<double, Order> a;
  bool measurable = true;
  for (std::size_t i = 0; i < Order; ++i) {
    measurable &= form.size(corners[i]) > QuadricForm::kSmallestSize;
    for (std::size_t j = 0; j < Order; ++j)
      a[i][j] = form[corners[i]][corners[j]] / (form.size(corners[i]) * form.size(corners[j]));
  }
  if (measurable && is_clearly_regular(a)) return false;
  SquareMatrix<Rational, Order> e;
  bool is_below = true;
  for (std::size_t i = 0; i < Order; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      e[i][j] = e[j][i] = form.exact(corners[i], corners[j]);
      is_below &= e[i][j] <= 0;
    }
  if (is_below || determinant_of<Rational, Order>(e) != 0) return false;
  const auto kernel = last_cofactors<Rational, Order>(e);
  const auto has = [&](const auto& test) {
    return std::any_of(kernel.begin(), kernel.end(), test);
  };
  const bool any_positive = has([](const Rational& x) { return x > 0; });
  const bool any_negative = has([](const Rational& x) { return x < 0; });
  // In an edge a zero entry is where the level touches it at its end: (q, 0; 0, 0).
  if constexpr (Order == 2)
    if (e[0][1] == 0) return true;
  return any_positive != any_negative && !has([](const Rational& x) { return x == 0; });
}

}  // namespace

std::string critical_reason(const TetMesh& mesh, const QuadraticLevel& level,
                            const std::array<TetMesh::Index, 4>& vertices) {
  std::array<const SymmetricTensor<double>*, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i)
    tensors[i] = &mesh.tensors[static_cast<std::size_t>(vertices[i])];
  const QuadricForm form(level, tensors);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (is_critical<2>(form, {i, j})) return "critical_value_on_edge";
  for (std::size_t i = 0; i < 4; ++i)
    if (is_critical<3>(form, {i == 0 ? 1u : 0u, i < 2 ? 2u : 1u, i < 3 ? 3u : 2u}))
      return "critical_value_on_face";
  return is_critical<4>(form, {0, 1, 2, 3}) ? "critical_value_in_cell" : "";
}

}  // namespace tensortopo
