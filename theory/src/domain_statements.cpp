// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The real and the complex domain on the sphere of medium eigenvectors.
#include <functional>

#include "dominant_form.hpp"
#include "groups.hpp"
#include "tensortopo/theory/checks.hpp"

namespace tensortopo::theory {
namespace {

std::string place(const Tensor& n, const Vector3<Rational>& v, const Rational& s) {
  return "characteristic tensor along " + text(n) + ", s = " + s.str() + ", v = " + text(v);
}

// With the projected tensor, which maps v to zero, as the theorem is printed.
Outcome printed_domain_at_witness() {
  const TetrahedronField<Rational> field = witness_field();
  const Tensor n = *characteristic_multiple(field);
  const Basis basis = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const Rational s = Rational(1) / Rational(2);
  const Tensor projected = {n.xx, n.yy, 0, n.xy, 0, 0};
  const Vector3<Rational> image = projected * basis[2];
  const Rational alpha = dot(basis[2], image), beta = dot(image, image);
  const Rational printed = inner(n, n) / Rational(2) - beta + boundary_weight(s) * alpha * alpha;
  const bool none = dominant_form(n, basis, s).discriminant() < 0;
  if (printed < 0 || !none) return Outcome::holds();
  return Outcome::violated(place(n, basis[2], s) +
                           ": the printed sign is that of the real domain, which v is not in");
}

// A tensor of the field with medium eigenvector v: its parameter |s| and its dominant direction.
struct Member {
  Rational s;
  Vector3<Rational> dominant;
};

// The field's tensors with medium eigenvector v and one eigenvector along d are solutions of one
// linear equation for s; negative s exchanges the roles of d and of the vector across it.
std::optional<Member> random_member(const Tensor& n, const Basis& basis, Random& random) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    const Vector3<Rational> d =
        Rational(random.integer(-9, 9)) * basis[0] + Rational(random.integer(-9, 9)) * basis[1];
    const Rational at_zero = inner(n, tensor_with(Rational(0), basis[2], d));
    const Rational at_one = inner(n, tensor_with(Rational(1), basis[2], d));
    if (at_zero == at_one) continue;
    const Rational s = at_zero / (at_zero - at_one);
    if (s < -1 || s > 1) continue;
    if (s < 0) return Member{-s, cross(basis[2], d)};
    return Member{s, d};
  }
  return std::nullopt;
}

// Hands a check the characteristic tensor, a basis and a tensor of the field.
using MemberCheck = std::function<Outcome(const Tensor&, const Basis&, const Member&, Random&)>;

Check with_member(const MemberCheck& check) {
  return [check](const Trial& trial) {
    const auto n = characteristic_multiple(trial.field);
    if (!n) return Outcome::not_applicable("rank below 4");
    Random random = trial.random;
    const Basis basis = random_basis(random);
    const auto member = random_member(*n, basis, random);
    if (!member) return Outcome::not_applicable("no rational tensor found with this eigenvector");
    if (inner(*n, tensor_with(member->s, basis[2], member->dominant)) != 0) {
      return Outcome::violated("not in the field: " + place(*n, basis[2], member->s));
    }
    return check(*n, basis, *member, random);
  };
}

Outcome check_medium_vectors(const Tensor& n, const Basis& basis, const Member& member,
                             Random& random) {
  // In the real domain of its own mode and of every smaller one.
  for (const Rational& s : {member.s, Rational(member.s * random.part())}) {
    if (boundary_form(n, basis[2], boundary_weight(s)) < 0) {
      return Outcome::violated(place(n, basis[2], s) + ", dominant " + text(member.dominant));
    }
  }
  return Outcome::holds();
}

Outcome grey_vector_at_witness() {
  const TetrahedronField<Rational> field = witness_field();
  const Tensor n = *characteristic_multiple(field);
  const Vector3<Rational> v = {0, 0, 1};
  const Rational s = Rational(1) / Rational(2);
  // Eigenvalues 1, 0 and -1: v spans the kernel.
  const Tensor t = to_tensor(field.vertex[0]);
  const bool medium = t * v == Vector3<Rational>{} && determinant(t) == 0 && inner(t, n) == 0;
  if (!medium || boundary_form(n, v, boundary_weight(s)) >= 0) return Outcome::holds();
  return Outcome::violated(place(n, v, s) +
                           ": in the complex domain, and the medium eigenvector "
                           "of " +
                           text(t) + " in the field");
}

Outcome check_signed_root(const Tensor& n, const Basis& basis, const Member& member, Random&) {
  const Vector3<Rational>& d = member.dominant;
  const Rational sigma = dot(d, n * cross(basis[2], d)), size = dot(d, d);
  const Rational form = boundary_form(n, basis[2], boundary_weight(member.s));
  if (sigma * sigma == size * size * form) return Outcome::holds();
  return Outcome::violated(place(n, basis[2], member.s) + ", dominant " + text(d));
}

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
    sum =
        (order - k) % 2 == 0 ? Rational(sum + binomial * value) : Rational(sum - binomial * value);
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

Outcome check_boundary_degree(const Trial& trial) {
  const auto n = characteristic_multiple(trial.field);
  if (!n) return Outcome::not_applicable("rank below 4");
  Random random = trial.random;
  const Rational s = random.part(), weight = boundary_weight(s);
  const bool as_claimed = part_vanishes(*n, weight, 6) && part_vanishes(*n, weight, 5) &&
                          part_vanishes(*n, weight, 4) == (s == 1);
  return as_claimed
             ? Outcome::holds()
             : Outcome::violated("characteristic tensor along " + text(*n) + ", s = " + s.str());
}

Outcome degree_six_at_witness() {
  const Tensor n = *characteristic_multiple(witness_field());
  const Rational s = Rational(1) / Rational(2);
  if (!part_vanishes(n, boundary_weight(s), 6)) return Outcome::holds();
  return Outcome::violated("characteristic tensor along " + text(n) + ", s = " + s.str() +
                           ": the terms of degree six vanish");
}

}  // namespace

Check check_real_domain(const Rational& quarter) {
  return [quarter](const Trial& trial) {
    const auto n = characteristic_multiple(trial.field);
    if (!n) return Outcome::not_applicable("rank below 4");
    Random random = trial.random;
    for (int i = 0; i < 3; ++i) {
      const Basis basis = random_basis(random);
      const Rational s = random.part();
      const Rational form = boundary_form(*n, basis[2], quarter * (Rational(1) - s * s));
      if (sign_of(form) != sign_of(dominant_form(*n, basis, s).discriminant())) {
        return Outcome::violated(place(*n, basis[2], s));
      }
    }
    return Outcome::holds();
  };
}

std::vector<Statement> domain_statements() {
  return {
      {"complex-domain-vectors", "Mode Surfaces Analysis, the grey region",
       "A unit vector in the complex domain is not the medium eigenvector of any tensor of the "
       "field.",
       "a field of rank 4 and one of its tensors, with rational eigenvectors",
       "Of no tensor whose mode is mu or -mu, or farther from 0: tensors closer to neutral can "
       "have it.",
       with_member(check_medium_vectors), grey_vector_at_witness},
      {"boundary-degree", "Mode Surfaces Analysis, after the boundary's equation",
       "The boundary of the complex domain is given by a polynomial of degree six.",
       "a field of rank 4", "Of degree four in the coordinates of v, and of degree two if mu = 1.",
       check_boundary_degree, degree_six_at_witness},
      {"real-domain", "Theorem 2",
       "v is in the real domain if and only if 1/2 - v.T'^2 v + cos^2(theta) (v.T' v)^2 / 4 >= 0, "
       "T' being the characteristic tensor projected to the plane across v.",
       "a field of rank 4; mu of a rational parameter s, v in a rational basis",
       "With the characteristic tensor itself; zero exactly on the boundary.", check_real_domain(),
       printed_domain_at_witness},
      {"signed-root",
       "none (used to find the boundary along mode curves)",
       "At a tensor of the field with medium eigenvector v and dominant eigenvector d, the "
       "boundary function of v is the square of d.T (v x d), T characteristic.",
       "a field of rank 4 and one of its tensors, with rational eigenvectors",
       "",
       with_member(check_signed_root),
       {}},
  };
}

}  // namespace tensortopo::theory
