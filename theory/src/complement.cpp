// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "complement.hpp"

#include <array>
#include <utility>

namespace tensortopo::theory {
namespace {

using Row = std::array<Rational, 5>;

// The linear form <T, .> on traceless tensors, in the coordinates xx, yy, xy, yz, xz.
Row row_of(const Tensor& t) {
  return {t.xx - t.zz, t.yy - t.zz, Rational(2) * t.xy, Rational(2) * t.yz, Rational(2) * t.xz};
}

}  // namespace

std::vector<Tensor> orthogonal_complement(std::span<const Tensor> tensors) {
  std::vector<Row> rows;
  for (const Tensor& t : tensors) rows.push_back(row_of(t));
  std::array<int, 5> pivot_row;
  pivot_row.fill(-1);
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 5 && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[pivot], rows[rank]);
    const Rational scale = rows[rank][column];
    for (Rational& entry : rows[rank]) entry = entry / scale;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Rational factor = rows[i][column];
      if (i == rank || factor == 0) continue;
      for (std::size_t j = 0; j < 5; ++j) rows[i][j] = rows[i][j] - factor * rows[rank][j];
    }
    pivot_row[column] = static_cast<int>(rank++);
  }
  std::vector<Tensor> basis;
  for (std::size_t free = 0; free < 5; ++free) {
    if (pivot_row[free] >= 0) continue;
    Row x{};
    x[free] = 1;
    for (std::size_t column = 0; column < 5; ++column) {
      if (pivot_row[column] >= 0)
        x[column] = -rows[static_cast<std::size_t>(pivot_row[column])][free];
    }
    basis.push_back({x[0], x[1], -(x[0] + x[1]), x[2], x[3], x[4]});
  }
  return basis;
}

std::vector<Tensor> orthogonal_complement(const TetrahedronField<Rational>& field) {
  std::array<Tensor, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i) tensors[i] = to_tensor(field.vertex[i]);
  return orthogonal_complement(tensors);
}

}  // namespace tensortopo::theory
