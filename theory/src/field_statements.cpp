// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The characteristic tensor of a linear field.
#include <algorithm>
#include <array>

#include "groups.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::theory {
namespace {

using Tensor = SymmetricTensor<Rational>;
using Row = std::array<Rational, 5>;

// The linear form <T, .> on traceless tensors, in the coordinates xx, yy, xy, yz, xz.
Row row_of(const Tensor& t) {
  return {t.xx - t.zz, t.yy - t.zz, Rational(2) * t.xy, Rational(2) * t.yz, Rational(2) * t.xz};
}

// Traceless tensors orthogonal to the field: a basis, by elimination to reduced echelon form. It
// shares nothing with the cross product of lib/field that it is compared to.
std::vector<Tensor> orthogonal_complement(const TetrahedronField<Rational>& field) {
  std::array<Row, 4> rows;
  for (std::size_t i = 0; i < 4; ++i) rows[i] = row_of(to_tensor(field.vertex[i]));
  std::array<int, 5> pivot_row;
  pivot_row.fill(-1);
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 5 && rank < 4; ++column) {
    std::size_t pivot = rank;
    while (pivot < 4 && rows[pivot][column] == 0) ++pivot;
    if (pivot == 4) continue;
    std::swap(rows[pivot], rows[rank]);
    const Rational scale = rows[rank][column];
    for (Rational& entry : rows[rank]) entry = entry / scale;
    for (std::size_t i = 0; i < 4; ++i) {
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

bool is_orthogonal(const Tensor& t, const TetrahedronField<Rational>& field) {
  return std::all_of(field.vertex.begin(), field.vertex.end(),
                     [&](const Deviator<Rational>& d) { return inner(t, to_tensor(d)) == 0; });
}

Outcome check_characteristic_tensor(const Trial& trial) {
  const std::vector<Tensor> basis = orthogonal_complement(trial.field);
  const std::size_t rank = 5 - basis.size();
  if (static_cast<int>(rank) != field_rank(trial.field)) {
    return Outcome::violated("rank " + std::to_string(rank));
  }
  for (const Tensor& t : basis) {
    if (t == Tensor{} || !is_orthogonal(t, trial.field)) return Outcome::violated(text(t));
  }
  const Tensor direction = to_tensor(characteristic_direction(trial.field));
  if (rank < 4) {
    // Two independent candidates, and either sign of each: nothing is unique.
    return basis.size() >= 2 && direction == Tensor{} ? Outcome::holds()
                                                      : Outcome::violated(text(direction));
  }
  // A line of candidates, on which the determinant chooses a half unless it is zero.
  const Rational across = inner(basis[0], direction);
  const bool parallel = across * across == inner(basis[0], basis[0]) * inner(direction, direction);
  const Rational det = determinant(direction), opposite = determinant(Rational(-1) * direction);
  const int candidates = (det <= 0 ? 1 : 0) + (opposite <= 0 ? 1 : 0);
  const bool as_claimed = direction != Tensor{} && parallel &&
                          is_orthogonal(direction, trial.field) && det <= 0 &&
                          candidates == (det == 0 ? 2 : 1);
  return as_claimed ? Outcome::holds() : Outcome::violated(text(direction));
}

// A field for which both signs of the orthogonal tensor meet the three conditions.
Outcome two_characteristic_tensors() {
  TetrahedronField<Rational> field;
  field.vertex = {deviator(Tensor{1, -1, 0, 0, 0, 0}), deviator(Tensor{0, 1, -1, 0, 0, 0}),
                  deviator(Tensor{0, 0, 0, 1, 0, 0}), deviator(Tensor{0, 0, 0, 0, 1, 0})};
  const Tensor t = {0, 0, 0, 0, 0, 1}, opposite = Rational(-1) * t;
  const bool both = field_rank(field) == 4 && is_orthogonal(t, field) &&
                    is_orthogonal(opposite, field) && determinant(t) <= 0 &&
                    determinant(opposite) <= 0;
  if (!both) return Outcome::holds();
  return Outcome::violated("field " + text(field) + ": multiples of " + text(t) + " and of " +
                           text(opposite) + " meet all conditions");
}

}  // namespace

std::vector<Statement> field_statements() {
  return {
      {"characteristic-tensor", "3D Linear Tensor Fields, conditions on the characteristic tensor",
       "A linear field of independent tensors has one unit tensor that is orthogonal to it and "
       "of determinant at most 0.",
       "any linear field",
       "It exists always, but it is unique only if the four tensors have rank 4 and its "
       "determinant is not 0: at determinant 0 both signs will do, below rank 4 infinitely many.",
       check_characteristic_tensor, two_characteristic_tensors},
  };
}

}  // namespace tensortopo::theory
