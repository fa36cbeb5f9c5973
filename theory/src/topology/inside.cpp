// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Mode surfaces inside one tetrahedron.
#include "dominant_form.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "topology/boundary_curve.hpp"
#include "topology/checks.hpp"
#include "topology/tensor_sphere.hpp"

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

const Basis kAxes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

// Eigenvalues of a characteristic tensor and a tetrahedron that, in its eigenvectors, holds one of
// the two loops of the complex domain's boundary inside.
struct HandleField {
  std::array<int, 3> eigenvalues;
  std::array<int, 3> corner;
};

constexpr std::array kHandleFields = {HandleField{{5, 3, -8}, {3, 24, 11}},
                                      HandleField{{2, 1, -3}, {4, 12, 8}}};

// x D - (1 + l1 x) e1 e3 + y e1 e2 + z e2 e3 at corners (+-x, +-y, +-z) of an even number of minus
// signs, with D as the tensor at which the surface is critical.
std::array<Tensor, 4> tensors_at_corners(const HandleField& field, const Basis& e) {
  const auto [l1, l2, l3] = field.eigenvalues;
  const Tensor d = tensor_of({Rational(l2 - l3), Rational(l3 - l1), Rational(l1 - l2)}, e);
  const Rational two(2);
  const Tensor e13 = two * product_of(e[0], e[2]), e12 = two * product_of(e[0], e[1]),
               e23 = two * product_of(e[1], e[2]);
  std::array<Tensor, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const int sign_x = i < 2 ? 1 : -1, sign_y = i % 2 == 0 ? 1 : -1;
    const Rational x(sign_x * field.corner[0]), y(sign_y * field.corner[1]),
        z(sign_x * sign_y * field.corner[2]);
    result[i] = x * d - Rational(Rational(1) + Rational(l1) * x) * e13 + y * e12 + z * e23;
  }
  return result;
}

std::array<Deviator<Rational>, 4> deviators(const std::array<Tensor, 4>& tensors) {
  return {deviator(tensors[0]), deviator(tensors[1]), deviator(tensors[2]), deviator(tensors[3])};
}

std::string handle_place(const std::array<Tensor, 4>& tensors, const Rational& s,
                         const LevelSurface& surface) {
  return "field " + text(TetrahedronField<Rational>{deviators(tensors)}) + ", s = " + s.str() +
         ": " + text(surface);
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
  const Rational s = fraction(random.integer(20, 900), 1009);
  const ModeLevel level = ModeLevel::of_parameter(s, random.integer(0, 1) == 0 ? 1 : -1);
  const auto surface = tetrahedron_surface(trial.field.vertex, level);
  if (!surface) return facts.undecided(kBudgetExceeded);
  facts.about([&] {
    return "s = " + s.str() + (level.sign > 0 ? ": " : ", negative mode: ") + text(*surface);
  });
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
  return Outcome::violated("field " + text(field) + " of rank " + std::to_string(rank) +
                           ": mode 0 in the whole tetrahedron, which no curves in its faces bound");
}

// Inside a tetrahedron, where the surface is not made of discs only: a cylinder.
Outcome orientable_neutral_surface() {
  const std::array<Tensor, 4> corners = tensors_at_corners(kHandleFields[1], kAxes);
  const auto surface = tetrahedron_surface(deviators(corners), ModeLevel::neutral());
  if (!surface || surface->euler != 0 || !surface->orientable) return Outcome::holds();
  return Outcome::violated(handle_place(corners, Rational(0), *surface));
}

void interior_boundary_loop(const Trial& trial, Facts<Rational>& facts) {
  if (!trial.frame) return facts.not_applicable("no rational eigenvectors");
  Random random = trial.random;
  const auto& kind = kHandleFields[static_cast<std::size_t>(random.integer(0, 1))];
  const auto& l = kind.eigenvalues;
  const Basis& e = trial.frame->eigenvectors;
  const std::array<Rational, 3> values = {Rational(l[0]), Rational(l[1]), Rational(l[2])};
  const std::array<Tensor, 4> corners = tensors_at_corners(kind, e);
  const Tensor n = tensor_of(values, e);
  const Rational critical = fraction(l[0] - l[1], l[0] + l[1]);
  const Rational below = critical * fraction(random.integer(75, 95), 100);
  const Rational above = critical * fraction(random.integer(105, 120), 100);
  for (const Tensor& t : corners) facts.zero("<tensor, characteristic tensor>", inner(t, n));
  const int holes_below = facts.claimed_count(1), holes_above = facts.claimed_count(0);
  const int loops = facts.claimed_count(2), pieces = facts.claimed_count(1);
  for (const Rational& s : {below, above}) {
    const auto surface = tetrahedron_surface(deviators(corners), ModeLevel::of_parameter(s));
    if (!surface) return facts.undecided(kBudgetExceeded);
    facts.about([&] { return handle_place(corners, s, *surface); });
    const int holes = s == below ? holes_below : holes_above;
    facts.holds("components", surface->components == pieces);
    facts.holds("boundary loops", surface->boundary_loops == loops);
    facts.holds("Euler characteristic", surface->euler == 2 - 2 * holes - loops);
  }
  facts.about([&] { return "field " + text(TetrahedronField<Rational>{deviators(corners)}); });
  // Turned to the eigenvectors: that changes no weights.
  facts.holds("a loop of the complex domain's boundary is inside and meets no face",
              loop_is_inside(values, below, tensors_at_corners(kind, kAxes), 1));
}

Outcome handle_in_tetrahedron() {
  const HandleField& kind = kHandleFields[0];
  const Rational s = fraction(6, 25);
  const std::array<Tensor, 4> corners = tensors_at_corners(kind, kAxes);
  const auto surface = tetrahedron_surface(deviators(corners), ModeLevel::of_parameter(s));
  const bool inside = loop_is_inside({5, 3, -8}, s, corners, 1);
  // Each part of the sphere that is cut out by images of face curves alone is a sphere with holes:
  // its Euler characteristic is 2 less their number.
  const bool handle =
      surface && surface->euler != 2 * surface->components - surface->boundary_loops;
  if (!inside || !handle) return Outcome::holds();
  return Outcome::violated(handle_place(corners, s, *surface) +
                           "; a loop of the complex domain's boundary is inside and meets no face");
}

}  // namespace tensortopo::theory
