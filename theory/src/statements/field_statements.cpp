// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Linear fields: the characteristic tensor, and the points of space against tensors of the span.
#include <algorithm>

#include "complement.hpp"
#include "dominant_form.hpp"
#include "groups.hpp"

namespace tensortopo::theory {
namespace {

bool is_orthogonal(const Tensor& t, const TetrahedronField<Rational>& field) {
  return std::all_of(field.vertex.begin(), field.vertex.end(),
                     [&](const Deviator<Rational>& d) { return inner(t, to_tensor(d)) == 0; });
}

void characteristic_tensor_of(const Trial& trial, Facts<Rational>& facts) {
  const std::vector<Tensor> basis = orthogonal_complement(trial.field);
  const int rank = facts.claimed_count(5) - static_cast<int>(basis.size());
  facts.about([&] { return "rank " + std::to_string(rank); });
  facts.holds("rank and dimension of the complement", rank == field_rank(trial.field));
  for (const Tensor& t : basis) {
    facts.holds("orthogonality of the complement", t != Tensor{} && is_orthogonal(t, trial.field));
  }
  const Tensor direction = to_tensor(characteristic_direction(trial.field));
  facts.about([&] { return text(direction); });
  if (rank < 4) {
    // Two independent candidates, and either sign of each: nothing is unique.
    facts.holds("two candidates below rank 4", basis.size() >= 2 && direction == Tensor{});
    return;
  }
  // A line of candidates, on which the determinant chooses a half unless it is zero.
  const Rational across = inner(basis[0], direction);
  facts.equal("<T, basis>^2 and the norms, as of parallel tensors", across * across,
              inner(basis[0], basis[0]) * inner(direction, direction));
  const Rational det = determinant(direction), opposite = determinant(Rational(-1) * direction);
  const int candidates = (det <= 0 ? 1 : 0) + (opposite <= 0 ? 1 : 0);
  facts.holds("direction", direction != Tensor{} && is_orthogonal(direction, trial.field));
  facts.not_positive("determinant", det);
  facts.holds("signs that satisfy the conditions",
              candidates == facts.claimed_count(det == 0 ? 2 : 1));
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
  return Outcome::violated("vertex tensors " + text(field) + ": multiples of " + text(t) +
                           " and of " + text(opposite) + " meet all conditions");
}

// The tensor t = sum of b_i T_i belongs to the point of weights b_i / c, c their sum.
const auto points_of_tensors = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  Random random = trial.random;
  std::array<Rational, 4> b;
  for (Rational& weight : b) weight = random.fraction();
  const Rational c = b[0] + b[1] + b[2] + b[3];
  if (c == 0) return facts.not_applicable("weights of sum 0 were drawn");
  const Tensor t = to_tensor(trial.field.at(b));
  const auto sum = facts.number(c);
  SymmetricTensor<Scalar> at_point = isotropic(Scalar(0));
  for (std::size_t i = 0; i < 4; ++i) {
    const auto vertex = facts.tensor(to_tensor(trial.field.vertex[i]));
    at_point = at_point + (facts.number(b[i]) / sum) * vertex;
  }
  facts.about([&] { return text(t) + ", sum of weights " + c.str(); });
  const auto scale = facts.claimed(1);
  facts.equal("the tensor at the point, times the sum", sum * at_point, scale * facts.tensor(t));
  facts.sign("determinant at the point", determinant(at_point),
             sign_of(c) * sign_of(determinant(t)));
  facts.equal("mode^2 at the point, as a form", inner(at_point, at_point) * squared(sum),
              facts.number(inner(t, t)));
};

// xy + xz - 2 yz is of the field with weights of sum 0, and of mode^2 1/2.
Outcome tensor_at_infinity() {
  const TetrahedronField<Rational> field = witness_field();
  const Tensor t = to_tensor(field.at({1, 1, -2, 0}));
  if (field_rank(field) != 4 || mode_squared(t) != fraction(1, 2)) return Outcome::holds();
  return Outcome::violated(text(t) + " of the span of the vertex tensors " + text(field) +
                           " has mode^2 = 1/2 and weights 1, 1, -2, 0, of sum 0: its medium "
                           "eigenvector has this tensor and no point in space");
}

}  // namespace

std::vector<Statement> field_statements() {
  return {
      {.id = "characteristic-tensor",
       .paper = "3D Linear Tensor Fields, conditions on the characteristic tensor",
       .claim =
           "Under structurally stable conditions a unit tensor exists that is orthogonal to the "
           "field and of determinant at most 0.",
       .hypotheses = "any linear field",
       .sharper = "It exists always. It is unique if the four tensors have rank 4 and its "
                  "determinant is not 0: at determinant 0 both signs will do, below rank 4 "
                  "infinitely many.",
       .special = "Rank below 4 (planes of symmetry, plane strain, a zero tensor at a vertex); "
                  "determinant 0.",
       .check = characteristic_tensor_of,
       .needed = {{"determinant not 0, for uniqueness", two_characteristic_tensors}}},
      {.id = "points-of-vectors",
       .paper = "Mode Surfaces Analysis, colours of the sphere",
       .claim = "Two antipodal vectors of the real domain belong to two points of the generalized "
                "mode surface; their modes, mu or -mu, give the vectors their colour.",
       .hypotheses = "a linear field, and a tensor of its span whose weights have a sum other "
                     "than 0",
       .corrected = "To two tensors of the span: t belongs to the point of weights b / c, where "
                    "t = sum of b_i T_i and c is the sum of the b_i, and the mode there is that of "
                    "t if c > 0, the opposite if c < 0. At c = 0 the point is at infinity.",
       .special = "The plane at infinity c = 0, which separates the colours.",
       .flaws = {Flaw::projective},
       .check = points_of_tensors,
       .paper_at_witness = tensor_at_infinity,
       .steps = {"points-at-infinity"},
       .restates = "what the weights of a point are"},
  };
}

}  // namespace tensortopo::theory
