// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Critical points of the mode on a mesh.
#include <array>

#include "groups.hpp"
#include "tensors.hpp"

namespace tensortopo::theory {
namespace {

// |T|^2 T^2 - 3 det(T) T - |T|^4 I / 3.
template <class Scalar>
SymmetricTensor<Scalar> dual_of(const SymmetricTensor<Scalar>& t) {
  const Scalar norm = inner(t, t), three(3);
  return norm * square(t) - three * determinant(t) * t - isotropic(Scalar(norm * norm / three));
}

// The derivative of the determinant at t along u: the part of degree one of det(t + k u).
template <class Scalar>
Scalar determinant_along(const SymmetricTensor<Scalar>& t, const SymmetricTensor<Scalar>& u) {
  return (determinant(t + u) - determinant(t - u)) / Scalar(2) - determinant(u);
}

// 2 P Q' - 3 Q P' along u, P = |T|^2 and Q = det T, which has the sign of the mode's derivative.
template <class Scalar>
Scalar slope(const SymmetricTensor<Scalar>& t, const SymmetricTensor<Scalar>& u,
             const Scalar& two = Scalar(2), const Scalar& three = Scalar(3)) {
  return two * inner(t, t) * determinant_along(t, u) -
         three * determinant(t) * (Scalar(2) * inner(t, u));
}

const auto derivative_in_star = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  const Tensor point = tensor_at_random_point(trial, random), normal = dual_of(point);
  if (inner(normal, normal) == 0) return facts.not_applicable("a degenerate tensor, or zero");
  // Along these the mode is critical at the point.
  const auto inside = [&] {
    const Tensor any = tensor_at_random_point(trial, random);
    return any - Rational(inner(normal, any) / inner(normal, normal)) * normal;
  };
  const std::array<Tensor, 2> simplex = {inside(), inside()};
  const std::array<Tensor, 2> others = {tensor_at_random_point(trial, random),
                                        tensor_at_random_point(trial, random)};
  const std::array<Rational, 2> weights = {random.part(), random.part()};
  const Tensor in_star = random.part() * point + random.part() * simplex[0] +
                         random.part() * simplex[1] + weights[0] * others[0] +
                         weights[1] * others[1];
  facts.configuration(
      {mode_squared(point), Rational(inner(point, others[0]) / inner(point, point)), weights[0]});
  facts.about([&] { return text(point) + " towards " + text(in_star); });
  const auto t = facts.tensor(point);
  const auto two = facts.claimed(2), three = facts.claimed(3), factor = facts.claimed(2);
  const auto along = [&](const Tensor& u) { return slope(t, facts.tensor(u), two, three); };
  facts.zero("derivative along the ray", along(point));
  for (const Tensor& u : simplex) facts.zero("derivative along the simplex", along(u));
  for (const Tensor& u : others)
    facts.equal("derivative, and the inner product with the dual", along(u),
                factor * inner(dual_of(t), facts.tensor(u)));
  facts.equal(
      "derivative towards a point of the star", along(in_star),
      facts.number(weights[0]) * along(others[0]) + facts.number(weights[1]) * along(others[1]));
};

// The edge from (2, 0, -2) to (1, -4, 3) at its end, and xy as the third vertex.
Outcome star_of_point_that_is_not_critical() {
  const Tensor point = {1, 0, -1, 0, 0, 0}, along = {1, -2, 1, 0, 0, 0}, other = {0, 0, 0, 1, 0, 0};
  if (slope(point, other) != 0 || slope(point, Tensor(along + other)) == 0) return Outcome::holds();
  return Outcome::violated("at " + text(point) + " the derivative towards " + text(other) +
                           " is 0, and towards its sum with " + text(along) + " it is not");
}

}  // namespace

std::vector<Statement> star_statements() {
  return {
      {.id = "derivative-in-star",
       .paper = "none (critical points of the mode on a mesh)",
       .claim = "At a point that is critical along its simplex (vertex, edge, triangle), and not "
                "degenerate, the mode's derivative towards a point of a tetrahedron around it is, "
                "up to one positive factor, the sum of those towards the vertices that are not of "
                "the simplex, times their weights.",
       .hypotheses =
           "a tensor D that is not degenerate, two along which the mode is critical there, "
           "and two others",
       .sharper =
           "It is a positive multiple of <D*, T>, D* = |D|^2 D^2 - 3 det(D) D - |D|^4 I / 3, "
           "which is linear in T and zero at T = D. So the directions in which the mode grows "
           "are known from one sign for each vertex of the link.",
       .special = "At degenerate points D* is 0: the mode is 1 or -1, an extremum. Where the "
                  "derivative towards a vertex is 0 its sign says nothing.",
       .check = derivative_in_star,
       .needed = {{"a point that is critical along its simplex",
                   star_of_point_that_is_not_critical}},
       .unneeded = "a tensor that is not degenerate: else all of these derivatives are 0",
       .steps = {"mode-derivative", "critical-on-edge", "critical-plane-space"},
       .reader = "That components of {mode >= m} are born and meet at critical points only, and at "
                 "them as the index along the simplex and the parts of the link say towards which "
                 "the mode grows (Morse theory of "
                 "functions that are smooth on each simplex); that these parts are those of the "
                 "vertices of positive sign, joined by edges of the link."},
  };
}

}  // namespace tensortopo::theory
