// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// From a vector of the sphere to its tensor, and what two tetrahedra make of a common face.
#include "dominant_form.hpp"
#include "groups.hpp"
#include "member.hpp"

namespace tensortopo::theory {
namespace {

// What the closed form is made of: P projects to the plane across v, M is the traceless part there.
template <class Scalar>
struct Across {
  SymmetricTensor<Scalar> projection, restricted, traceless, along;
  Scalar alpha, anisotropy;

  Across(const SymmetricTensor<Scalar>& n, const std::array<Vector3<Scalar>, 3>& e) {
    along = projection_to(e[2]);
    projection = projection_to(e[0]) + projection_to(e[1]);
    const Scalar first = dot(e[0], n * e[0]), mixed = dot(e[0], n * e[1]),
                 last = dot(e[1], n * e[1]);
    alpha = -(first + last);
    restricted = in_plane(first, mixed, last, e);
    traceless = restricted + (alpha / Scalar(2)) * projection;
    // The squared anisotropic part of the restriction: |n|^2 / 2 - beta + alpha^2 / 4.
    anisotropy = squared(Scalar((first - last) / Scalar(2))) + squared(mixed);
  }
  static SymmetricTensor<Scalar> in_plane(const Scalar& first, const Scalar& mixed,
                                          const Scalar& last,
                                          const std::array<Vector3<Scalar>, 3>& e) {
    const auto both = projection_to(e[0] + e[1]) - projection_to(e[0]) - projection_to(e[1]);
    return first * projection_to(e[0]) + mixed * both + last * projection_to(e[1]);
  }
  /// v x M: turned by a quarter of a full turn.
  SymmetricTensor<Scalar> turned(const std::array<Vector3<Scalar>, 3>& e) const {
    const Scalar p = dot(e[0], traceless * e[0]), q = dot(e[0], traceless * e[1]);
    return in_plane(-q, p, q, e);
  }
};

const auto closed_form = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  Random random = trial.random;
  const Rational exact_s = random.part();
  const Made made = made_around(exact_s, random);
  const auto n = facts.tensor(made.characteristic);
  const auto e = basis_in(facts, made.basis);
  const Across<Scalar> across(n, e);
  const Scalar s = facts.number(exact_s), half = facts.claimed(1, 2);
  // The root of the boundary function is -sigma for the major eigenvector of A(v).
  const Scalar root = -dot(e[0], n * e[1]);
  const auto turning = Scalar(half * across.alpha * s) * across.traceless + root * across.turned(e);
  const Scalar l2 = facts.claimed(-2) * s, width = facts.claimed(6);
  const auto t = across.anisotropy * (l2 * across.along - Scalar(half * l2) * across.projection) +
                 Scalar(half * width) * turning;
  facts.about([&] { return place(made.characteristic, made.basis[2], exact_s); });
  facts.equal("closed form and tensor", t, across.anisotropy * facts.tensor(made.member));
  // The boundary function without its weighted term is this anisotropy.
  facts.equal("anisotropic part of the restriction", across.anisotropy,
              boundary_form(n, e[2], facts.claimed(1, 4)));
};

const auto form_on_boundary = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  Random random = trial.random;
  const Rational exact_s = random.part();
  const Made made = made_on_boundary(exact_s, random);
  const auto n = facts.tensor(made.characteristic);
  const auto e = basis_in(facts, made.basis);
  const Across<Scalar> across(n, e);
  const Scalar s = facts.number(exact_s), third = facts.claimed(1, 3), half = facts.claimed(1, 2);
  const auto t = across.restricted +
                 Scalar(half * across.alpha * (Scalar(1) + third * s * s)) * across.projection -
                 Scalar(third * s * s * across.alpha) * across.along;
  facts.about([&] { return place(made.characteristic, made.basis[2], exact_s); });
  const Scalar sixth = facts.claimed(1, 6);
  facts.equal("form on the boundary and tensor", t,
              Scalar(sixth * across.alpha * s) * facts.tensor(made.member));
  // So of the characteristic tensor with a determinant <= 0 the multiple is negative.
  if (determinant(made.characteristic) != 0) {
    facts.same_sign("alpha and the determinant", across.alpha, determinant(n));
  }
};

// Two fields with a common face, drawn at random but for one of its tensors. Whether that is on the
// boundary of one field says nothing of the other.
const auto points_on_shared_face = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  const Rational s = random.part();
  const Basis basis = random_basis(random);
  const Tensor common = tensor_with(s, basis[2], basis[0]);
  TetrahedronField<Rational> mine = trial.field;
  mine.vertex[0] = deviator(common);
  TetrahedronField<Rational> neighbour = mine;
  neighbour.vertex[3] = deviator(tensor_of({3, 1, -4}, random_basis(random)));
  const auto first = characteristic_multiple(mine), second = characteristic_multiple(neighbour);
  if (!first || !second) return facts.not_applicable("rank below 4");
  facts.about([&] { return place(*first, basis[2], s) + ", of the neighbour " + text(*second); });
  facts.configuration_of(mine, {inner(*second, *second), inner(*first, *second)});
  const auto e = basis_in(facts, basis);
  const auto weight = facts.claimed(1, 4) * facts.number(Rational(1 - s * s));
  for (const Tensor& exact : {*first, *second}) {
    const auto n = facts.tensor(exact);
    facts.zero("<T, t>", inner(n, facts.tensor(common)));
    const auto sigma = dot(e[0], n * e[1]);
    facts.equal("boundary function and the square of the field's own sigma", squared(sigma),
                boundary_form(n, e[2], weight));
  }
};

// diag(9, -7, -2) has s = 3 * 2 / (9 + 7) = 3/8; both characteristic tensors are orthogonal to it,
// and to the tensors xz and yz, which complete it to the tensors of a face.
Outcome different_points_on_a_face() {
  const Tensor t = {9, -7, -2, 0, 0, 0};
  const Tensor first = {5, 11, -16, 0, 0, 0};
  const Tensor second = {5, 11, -16, 1, 0, 0};
  const Tensor face[] = {t, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1}};
  for (const Tensor& of_face : face) {
    if (inner(of_face, first) != 0 || inner(of_face, second) != 0) return Outcome::holds();
  }
  const Vector3<Rational> v = {0, 0, 1};
  const Rational weight = boundary_weight(fraction(3, 8));
  if (boundary_form(first, v, weight) != 0 || boundary_form(second, v, weight) == 0) {
    return Outcome::holds();
  }
  return Outcome::violated("a face with the tensors " + text(face[0]) + ", " + text(face[1]) +
                           " and " + text(face[2]) +
                           ": the first is a boundary point for the "
                           "characteristic tensor along " +
                           text(first) + " and not for " + text(second) +
                           ", so the two polylines have different vertices");
}

}  // namespace

std::vector<Statement> lift_statements() {
  return {
      {.id = "tensor-of-vector",
       .paper = "Mode Surface Extraction inside a Tetrahedron, from a vector to its point",
       .claim =
           "The tensor of mode mu or -mu that belongs to a vector v has eigenvalues known from "
           "mu and its dominant eigenvector from A(v).",
       .hypotheses = "a field made around a tensor with rational eigenvectors",
       .sharper = "Without an eigenvector problem: -(l2/2) P + l2 v v^T + ((l1 - l3)/2) "
                  "[(alpha s/2) M + sqrt(Delta) v x M] / g, with P = I - v v^T, "
                  "alpha = v.T v, M = P T P + (alpha/2) P, g = 1/2 - v.T^2 v + alpha^2/4.",
       .special = "g = 0: v a singularity.",
       .check = closed_form,
       .steps = {"tensor-of-vector"}},
      {.id = "tensor-on-boundary",
       .paper = "none (the tensor on the boundary of the complex domain)",
       .claim = "On the boundary the tensor is a negative multiple of P T P + (alpha/2)(1 + s^2/3) "
                "P - (s^2/3) alpha v v^T, T characteristic.",
       .hypotheses = "a field made around a tensor on the boundary",
       .check = form_on_boundary,
       .steps = {"tensor-on-boundary"}},
      {.id = "shared-face",
       .paper = "Stitching Mode Surfaces from Adjacent Tets",
       .claim =
           "Surfaces from neighbouring tetrahedra have the same vertices on their common face, "
           "because its curves were found first.",
       .hypotheses = "two random fields with a common face, one of whose tensors has rational "
                     "eigenvectors",
       .corrected = "Only if the polyline has the boundary points of both tetrahedra: each inserts "
                    "those of its own characteristic tensor, and a tensor that is on the boundary "
                    "for one has sigma != 0 for the other unless d.T (v x d) = 0 for both.",
       .flaws = {Flaw::substantive},
       .check = points_on_shared_face,
       .paper_at_witness = different_points_on_a_face},
  };
}

}  // namespace tensortopo::theory
