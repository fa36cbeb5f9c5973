// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The real and the complex domain on the sphere of medium eigenvectors.
#include "dominant_form.hpp"
#include "groups.hpp"
#include "member.hpp"

namespace tensortopo::theory {
namespace {

const auto real_domain = [](const Trial& trial, auto& facts) {
  const auto exact = characteristic_multiple(trial.field);
  if (!exact) return facts.not_applicable("rank below 4");
  Random random = trial.random;
  const auto n = facts.tensor(*exact);
  const auto quarter = facts.claimed(1, 4);
  for (int i = 0; i < 3; ++i) {
    const Basis basis = random_basis(random);
    const Rational exact_s = random.part();
    const auto e = basis_in(facts, basis);
    const auto s = facts.number(exact_s);
    facts.about([&] { return place(*exact, basis[2], exact_s); });
    facts.same_sign("boundary function and number of dominant directions",
                    boundary_form(n, e[2], quarter * (facts.number(1) - s * s)),
                    dominant_form(n, e, s).discriminant());
  }
};

// With the projected tensor, which maps v to zero, as the theorem is printed.
Outcome printed_domain_at_witness() {
  const Tensor n = *characteristic_multiple(witness_field());
  const Rational s = fraction(1, 2);
  const Tensor projected = {n.xx, n.yy, 0, n.xy, 0, 0};
  const Vector3<Rational> v = axes()[2], image = projected * v;
  const Rational alpha = dot(v, image), beta = dot(image, image);
  const Rational printed = inner(n, n) / Rational(2) - beta + boundary_weight(s) * alpha * alpha;
  const bool none = dominant_form(n, axes(), s).discriminant() < 0;
  if (printed < 0 || !none) return Outcome::holds();
  return Outcome::violated(place(n, v, s) +
                           ": the printed sign is that of the real domain, which v is not in");
}

// Hands a check the characteristic tensor, a basis and a member of the field with rational vectors.
template <class FactsOf, class Function>
void with_member(const Trial& trial, FactsOf& facts, const Function& check) {
  const auto n = characteristic_multiple(trial.field);
  if (!n) return facts.not_applicable("rank below 4");
  Random random = trial.random;
  const Basis basis = random_basis(random);
  const auto member = random_member(*n, basis, random);
  if (!member) return facts.not_applicable("no rational tensor found with this eigenvector");
  facts.about(
      [&] { return place(*n, basis[2], member->s) + ", dominant " + text(member->dominant); });
  facts.zero(
      "<T, t> of a member t",
      inner(facts.tensor(*n), facts.tensor(tensor_with(member->s, basis[2], member->dominant))));
  check(*n, basis, *member, random);
}

const auto medium_vectors = [](const Trial& trial, auto& facts) {
  with_member(
      trial, facts, [&](const Tensor& n, const Basis& basis, const Member& member, Random& random) {
        // In the real domain of its own mode and of every smaller one; on its boundary for its own
        // mode exactly if sigma = 0.
        const auto quarter = facts.claimed(1, 4);
        for (const Rational& s : {member.s, Rational(member.s * random.part())}) {
          facts.not_negative("boundary function of the medium eigenvector",
                             boundary_form(facts.tensor(n), facts.vector(basis[2]),
                                           quarter * facts.number(Rational(1 - s * s))));
        }
        // A member with sigma = 0 is on the boundary: the bound is sharp.
        const Rational s = random.part();
        const Made made = made_on_boundary(s, random);
        facts.zero("boundary function where sigma is 0",
                   boundary_form(facts.tensor(made.characteristic), facts.vector(made.basis[2]),
                                 quarter * facts.number(Rational(1 - s * s))));
      });
};

Outcome grey_vector_at_witness() {
  const TetrahedronField<Rational> field = witness_field();
  const Tensor n = *characteristic_multiple(field);
  const Vector3<Rational> v = {0, 0, 1};
  const Rational s = fraction(1, 2);
  // Eigenvalues 1, 0 and -1: v spans the kernel.
  const Tensor t = to_tensor(field.vertex[0]);
  const bool medium = t * v == Vector3<Rational>{} && determinant(t) == 0 && inner(t, n) == 0;
  if (!medium || boundary_form(n, v, boundary_weight(s)) >= 0) return Outcome::holds();
  return Outcome::violated(place(n, v, s) +
                           ": in the complex domain, and the medium eigenvector of " + text(t) +
                           " in the field");
}

const auto signed_root = [](const Trial& trial, auto& facts) {
  with_member(
      trial, facts, [&](const Tensor& exact, const Basis& basis, const Member& member, Random&) {
        const auto n = facts.tensor(exact);
        const auto d = facts.vector(member.dominant), v = facts.vector(basis[2]);
        const auto sigma = dot(d, n * cross(v, d)), size = dot(d, d);
        const auto weight = facts.claimed(1, 4) * facts.number(Rational(1 - member.s * member.s));
        facts.equal("sigma^2 and the boundary function", squared(sigma),
                    squared(size) * boundary_form(n, v, weight));
      });
};

// The difference of this order, from the origin along w, of the boundary function as a polynomial
// in the coordinates of v; order! times the value at w of its part of that degree, if none is
// higher.
Rational difference(const Tensor& n, const Rational& weight, const Vector3<Rational>& w,
                    int order) {
  Rational sum(0), binomial(1);
  for (int k = 0; k <= order; ++k) {
    const Vector3<Rational> v = Rational(k) * w, image = n * v;
    const Rational alpha = dot(v, image);
    const Rational value = inner(n, n) / Rational(2) - dot(image, image) + weight * alpha * alpha;
    const Rational term = binomial * value;
    sum = (order - k) % 2 == 0 ? Rational(sum + term) : Rational(sum - term);
    binomial = binomial * Rational(order - k) / Rational(k + 1);
  }
  return sum;
}

// Whether the part of this degree vanishes, provided that none is higher: a form of degree k in
// three variables is zero if it is on the triangular lattice of order k.
bool part_vanishes(const Tensor& n, const Rational& weight, int degree) {
  for (int i = 0; i <= degree; ++i) {
    for (int j = 0; i + j <= degree; ++j) {
      const Vector3<Rational> w = {Rational(i), Rational(j), Rational(degree - i - j)};
      if (difference(n, weight, w, degree) != 0) return false;
    }
  }
  return true;
}

void boundary_degree(const Trial& trial, Facts<Rational>& facts) {
  const auto n = characteristic_multiple(trial.field);
  if (!n) return facts.not_applicable("rank below 4");
  Random random = trial.random;
  const Rational s = random.integer(0, 3) == 0 ? Rational(1) : random.part();
  const int degree = facts.claimed_count(s == 1 ? 2 : 4);
  const Rational weight = boundary_weight(s);
  facts.about([&] { return "characteristic tensor along " + text(*n) + ", s = " + s.str(); });
  for (int higher = 6; higher > degree; --higher) {
    facts.holds("a part above the degree vanishes", part_vanishes(*n, weight, higher));
  }
  facts.holds("the part of the degree does not vanish", !part_vanishes(*n, weight, degree));
}

Outcome degree_six_at_witness() {
  const Tensor n = *characteristic_multiple(witness_field());
  const Rational s = fraction(1, 2);
  if (!part_vanishes(n, boundary_weight(s), 6)) return Outcome::holds();
  return Outcome::violated("characteristic tensor along " + text(n) + ", s = " + s.str() +
                           ": the terms of degree six vanish");
}

}  // namespace

std::vector<Statement> domain_statements() {
  const std::string member = "a field of rank 4 and one of its tensors, with rational eigenvectors";
  return {
      {.id = "complex-domain-vectors",
       .paper = "Mode Surfaces Analysis, the grey region",
       .claim =
           "\"Unit vectors in this region cannot appear as the medium eigenvector of any tensor in "
           "the 3D linear tensor field.\"",
       .hypotheses = member,
       .corrected = "As the paper's next sentence says: \"there are no points in the generalized "
                    "mode mu surface that correspond to these unit vectors\". Nor is one of a mode "
                    "farther from 0; tensors closer to neutral can have it.",
       .flaws = {Flaw::wording},
       .check = medium_vectors,
       .paper_at_witness = grey_vector_at_witness,
       .steps = {"vectors-of-complex-domain", "sigma-squared", "nested"}},
      {.id = "boundary-degree",
       .paper = "Mode Surfaces Analysis, after the boundary's equation",
       .claim = "The boundary of the complex domain is given by a polynomial of degree six.",
       .hypotheses = "a field of rank 4",
       .corrected = "Of degree four in the coordinates of v, and of degree two if mu = 1.",
       .flaws = {Flaw::wording},
       .check = boundary_degree,
       .paper_at_witness = degree_six_at_witness,
       .steps = {"boundary-degree"}},
      {.id = "real-domain",
       .paper = "Theorem 2",
       .claim = "v is in the real domain if and only if 1/2 - v.T'^2 v + cos^2(theta) (v.T' v)^2 / "
                "4 >= 0, T' being the characteristic tensor projected to the plane across v.",
       .hypotheses = "a field of rank 4; mu of a rational parameter s, v in a rational basis",
       .corrected = "With the characteristic tensor itself, as the paper's proof and its "
                    "equation of the boundary have it; zero exactly on the boundary.",
       .flaws = {Flaw::wording},
       .check = real_domain,
       .paper_at_witness = printed_domain_at_witness,
       .steps = {"real-domain", "asymmetric-discriminant", "eigenvalue-cases", "projected-square",
                 "boundary-difference"}},
      {.id = "signed-root",
       .paper = "none (used to find the boundary along mode curves)",
       .claim =
           "At a tensor of the field with medium eigenvector v and dominant eigenvector d, the "
           "boundary function of v is the square of d.T (v x d), T characteristic.",
       .hypotheses = member,
       .check = signed_root,
       .steps = {"sigma-squared", "boundary-crossing"}},
  };
}

}  // namespace tensortopo::theory
