// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Mode surfaces inside one tetrahedron.
#include "levels/tensor_sphere.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "topology/checks.hpp"
#include "topology/loop_tetrahedron.hpp"

namespace tensortopo::theory {
namespace {

using Gram = std::array<std::array<Rational, 4>, 4>;

// The determinant without a row and a column, with the sign of its place.
Rational cofactor(const Gram& m, std::size_t row, std::size_t column) {
  std::array<Vector3<Rational>, 3> rest;
  for (std::size_t i = 0, k = 0; i < 4; ++i) {
    if (i == row) continue;
    std::array<Rational, 3> entries;
    for (std::size_t j = 0, h = 0; j < 4; ++j)
      if (j != column) entries[h++] = m[i][j];
    rest[k++] = {entries[0], entries[1], entries[2]};
  }
  const Rational value = dot(rest[0], cross(rest[1], rest[2]));
  return (row + column) % 2 == 0 ? value : Rational(-value);
}

// Whether a field of rank 3 vanishes in its tetrahedron: whether the one relation between its
// tensors has weights of one sign. They are cofactors of the matrix of inner products.
bool vanishes_inside(const TetrahedronField<Rational>& field) {
  Gram gram;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) gram[i][j] = norm_form(field.vertex[i], field.vertex[j]);
  std::size_t row = 0;
  while (cofactor(gram, row, row) == 0) ++row;
  bool positive = false, negative = false;
  for (std::size_t j = 0; j < 4; ++j) {
    const Rational weight = cofactor(gram, row, j);
    positive = positive || weight > 0;
    negative = negative || weight < 0;
  }
  return !(positive && negative);
}

}  // namespace

void no_closed_component(const Trial& trial, Facts<Rational>& facts) {
  const int rank = field_rank(trial.field);
  if (rank < 3) return facts.not_applicable("rank below 3");
  if (rank == 3 && vanishes_inside(trial.field)) {
    return facts.not_applicable("the field vanishes in the tetrahedron");
  }
  Random random = trial.random;
  // A denominator that no critical parameter of the trials has.
  Rational s = fraction(random.integer(20, 900), 1009);
  const int sign = random.integer(0, 1) == 0 ? 1 : -1;
  // Mode 0 where the neutral surface does not cross itself.
  const bool regular = rank == 4 && discriminant_form(characteristic_direction(trial.field)) != 0;
  if (regular && random.integer(0, 3) == 0) s = 0;
  const ModeLevel level = ModeLevel::of_parameter(s, sign);
  const auto surface = tetrahedron_surface(trial.field.vertex, level);
  if (!surface) return facts.undecided(kBudgetExceeded);
  facts.about([&] {
    return "s = " + s.str() + (level.sign > 0 ? ": " : ", negative mode: ") + text(*surface);
  });
  facts.configuration_of(trial.field, {s, Rational(sign)});
  facts.holds("components that meet no face", surface->closed_components == facts.claimed_count(0));
}

// Antiplane shear: all tensors of the field have determinant 0.
Outcome neutral_tetrahedron() {
  TetrahedronField<Rational> field;
  field.vertex = {deviator(Tensor{0, 0, 0, 0, 2, 1}), deviator(Tensor{0, 0, 0, 0, -1, 1}),
                  deviator(Tensor{0, 0, 0, 0, 1, 3}), deviator(Tensor{0, 0, 0, 0, 2, 4})};
  // A cubic form in four variables is zero if it is on the lattice of order three.
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; i + j <= 3; ++j)
      for (int k = 0; i + j + k <= 3; ++k)
        if (determinant_form(field.at({i, j, k, 3 - i - j - k})) != 0) return Outcome::holds();
  const int rank = field_rank(field);
  return Outcome::violated("vertex tensors " + text(field) + " of rank " + std::to_string(rank) +
                           ": mode 0 in the whole tetrahedron, which no curves in its faces bound");
}

// Inside a tetrahedron, where the surface is not made of discs only: a cylinder.
Outcome orientable_neutral_surface() {
  const LoopTetrahedron& t = loop_of_wide_handle();
  const auto surface = tetrahedron_surface(t.deviators(), ModeLevel::neutral());
  if (!surface || surface->euler != 0 || !surface->orientable) return Outcome::holds();
  return Outcome::violated("vertex tensors " + text(TetrahedronField<Rational>{t.deviators()}) +
                           ", s = 0: " + text(*surface));
}

}  // namespace tensortopo::theory
