// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The asymmetric matrix on the plane across a medium eigenvector (Theorem 1).
#include "dominant_form.hpp"
#include "groups.hpp"
#include "member.hpp"

namespace tensortopo::theory {
namespace {

template <class Scalar>
struct Matrix {
  Scalar a, b, c, d;  // rows (a, b) and (c, d)

  friend Matrix operator*(const Matrix& m, const Matrix& n) {
    return {m.a * n.a + m.b * n.c, m.a * n.b + m.b * n.d, m.c * n.a + m.d * n.c,
            m.c * n.b + m.d * n.d};
  }
  Matrix adjugate() const { return {d, -b, -c, a}; }
  Matrix transpose() const { return {a, c, b, d}; }
  // In the basis with its two vectors exchanged.
  Matrix swapped() const { return {d, c, b, a}; }
  std::array<Scalar, 4> entries() const { return {a, b, c, d}; }
};

// theta / 2 + pi / 4, an angle with rational cosine and sine; then sin(theta) is rational too.
struct Angle {
  Rational cosine, sine;

  Rational s() const { return sine * sine - cosine * cosine; }
};

// t is the tangent of half the angle: from above tan(pi / 8), that is mode 0, to 1, mode 1.
Angle angle_of(const Rational& t) {
  const Rational tt = t * t, size = Rational(1) + tt;
  return {Rational((Rational(1) - tt) / size), Rational((t + t) / size)};
}

Angle random_angle(Random& random) { return angle_of(fraction(random.integer(10, 23), 24)); }

template <class Scalar>
Matrix<Scalar> rotation(const Scalar& cosine, const Scalar& sine) {
  return {cosine, -sine, sine, cosine};
}

template <class Scalar>
Matrix<Scalar> restricted(const SymmetricTensor<Scalar>& n,
                          const std::array<Vector3<Scalar>, 3>& basis) {
  const Scalar across = dot(basis[0], n * basis[1]);
  return {dot(basis[0], n * basis[0]), across, across, dot(basis[1], n * basis[1])};
}

// R(theta/2 + pi/4) T' R(theta/2 - pi/4); the second angle is a quarter turn less than the first.
template <class Scalar>
Matrix<Scalar> asymmetric(const Matrix<Scalar>& t, const Scalar& cosine, const Scalar& sine) {
  return rotation(cosine, sine) * t * rotation(sine, -cosine);
}

std::string plane(const Tensor& n, const Basis& basis, const Angle& angle) {
  return place(n, basis[2], angle.s()) + ", basis " + text(basis[0]) + " and " + text(basis[1]);
}

const auto eigenvalue_count = [](const Trial& trial, auto& facts) {
  const auto exact = characteristic_multiple(trial.field);
  if (!exact) return facts.not_applicable("rank below 4");
  Random random = trial.random;
  const Basis basis = random_basis(random);
  const Angle angle = random_angle(random);
  const auto n = facts.tensor(*exact);
  const auto e = basis_in(facts, basis);
  const auto a = asymmetric(restricted(n, e), facts.number(angle.cosine), facts.number(angle.sine));
  const auto form = dominant_form(n, e, facts.number(angle.s()));
  facts.about([&] { return plane(*exact, basis, angle); });
  // Both d x A d and <n, t(d)> are quadratic forms of a direction d in the plane.
  const auto six = facts.claimed(6), three = facts.claimed(3);
  facts.equal("first coefficient of the form of dominant directions", six * a.c, form.first);
  facts.equal("mixed coefficient", three * (a.d - a.a), form.mixed);
  facts.equal("last coefficient", -(six * a.b), form.last);
  const auto four = facts.claimed(4);
  facts.same_sign("real eigenvalues and dominant directions", squared(a.a - a.d) + four * a.b * a.c,
                  form.discriminant());
};

// The characteristic tensor xz vanishes on the plane across z: every direction there is dominant.
Outcome infinitely_many_points() {
  const Tensor n = {0, 0, 0, 0, 0, 1};
  const Angle angle = angle_of(fraction(1, 2));
  const auto a = asymmetric(restricted(n, axes()), angle.cosine, angle.sine);
  const DominantForm<Rational> form = dominant_form(n, axes(), angle.s());
  const bool zero = a.a == 0 && a.b == 0 && a.c == 0 && a.d == 0;
  if (!zero || form.first != 0 || form.mixed != 0 || form.last != 0) return Outcome::holds();
  return Outcome::violated(plane(n, axes(), angle) +
                           ": one real eigenvalue, but a tensor for each direction of the plane");
}

const auto dominant_eigenvector = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  Random random = trial.random;
  const Angle angle = random_angle(random);
  const Made made = made_around(angle.s(), random);
  const auto n = facts.tensor(made.characteristic);
  const auto e = basis_in(facts, made.basis);
  const auto a = asymmetric(restricted(n, e), facts.number(angle.cosine), facts.number(angle.sine));
  // In this basis the dominant eigenvector is (1, 0).
  const Scalar sigma = dot(e[0], n * e[1]), half = facts.claimed(1, 2);
  facts.about([&] { return plane(made.characteristic, made.basis, angle); });
  facts.zero("what A adds across the dominant direction", a.c);
  facts.equal("eigenvalue of A and tr(A) / 2 - sigma", a.a, half * (a.a + a.d) - sigma);
};

const auto antipodal_matrix = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  const auto exact = characteristic_multiple(trial.field);
  if (!exact) return facts.not_applicable("rank below 4");
  Random random = trial.random;
  const Basis basis = random_basis(random);
  const Angle angle = random_angle(random);
  const auto n = facts.tensor(*exact);
  const Scalar cosine = facts.number(angle.cosine), sine = facts.number(angle.sine);
  const auto a = asymmetric(restricted(n, basis_in(facts, basis)), cosine, sine);
  // The right-handed basis of the opposite vector, and what was found there in the first basis.
  const Basis opposite = {basis[1], basis[0], -basis[2]};
  const auto there =
      asymmetric(restricted(n, basis_in(facts, opposite)), cosine, sine).swapped().entries();
  const auto adjugate = a.adjugate().entries();
  const Scalar factor = facts.claimed(1);
  facts.about([&] { return plane(*exact, basis, angle); });
  for (std::size_t i = 0; i < 4; ++i) {
    facts.equal("A(-v) and the adjugate of A(v)", there[i], factor * adjugate[i]);
  }
};

Outcome transpose_at_witness() {
  const Tensor n = {2, 1, -3, 0, 0, 0};
  const Angle angle = angle_of(fraction(1, 2));
  const auto t = restricted(n, axes());
  const auto reversed =
      rotation(angle.cosine, Rational(-angle.sine)) * t * rotation(angle.sine, angle.cosine);
  const auto transpose = asymmetric(t, angle.cosine, angle.sine).transpose();
  if (reversed.entries() == transpose.entries()) return Outcome::holds();
  return Outcome::violated(plane(n, axes(), angle) +
                           ": with both rotations reversed the matrix is not the transpose");
}

}  // namespace

std::vector<Statement> matrix_statements() {
  const std::string plane_known =
      "a field of rank 4; mu of a theta with a rational half angle, v in a rational basis";
  return {
      {.id = "medium-eigenvector-count",
       .paper = "Theorem 1",
       .claim = "For 0 < mu < 1, as many points of mode mu or -mu have the medium eigenvector v or "
                "-v as A(v) has real eigenvalues, and their dominant eigenvectors are eigenvectors "
                "of A(v).",
       .hypotheses = plane_known,
       .corrected =
           "Points at infinity included, in a basis with e1 x e2 = v, and unless A(v) is a "
           "multiple of the identity: then there is a point for every direction.",
       .special = "v a singularity and either mu = 0 or a characteristic tensor of determinant 0.",
       .flaws = {Flaw::projective, Flaw::exceptional},
       .check = eigenvalue_count,
       .paper_at_witness = infinitely_many_points,
       .steps = {"major-is-eigenvector", "minor-is-eigenvector", "eigenvectors-in-plane",
                 "eigenvalue-cases", "directions-are-roots", "points-of-isotropic-plane",
                 "points-at-infinity"},
       .reader = "Coq counts tensors of the span up to positive multiples; points of space are "
                 "those of a weight other than 0 (points-of-vectors)."},
      {.id = "dominant-eigenvector",
       .paper = "Theorem 1, which eigenvector belongs to which point",
       .claim = "The major and the minor eigenvector of A(v) each belong to one of the points with "
                "medium eigenvector v or -v.",
       .hypotheses = "a field made around a tensor with rational eigenvectors",
       .sharper = "The dominant eigenvector d has the eigenvalue tr(A) / 2 - sigma, "
                  "sigma = d.T (v x d), T characteristic: it is the major one exactly if "
                  "sigma < 0.",
       .check = dominant_eigenvector,
       .steps = {"dominant-eigenvector", "sigma-squared"}},
      {.id = "antipodal-matrix",
       .paper = "Theorem 1, end of the proof",
       .claim = "A(-v), whose rotations are reversed, is the transpose of A(v) in the same basis.",
       .hypotheses = plane_known,
       .corrected = "It is the adjugate: the same eigenvectors, with the two eigenvalues "
                    "exchanged. (The paper's conclusion, that v and -v have the same points, "
                    "stands.)",
       .flaws = {Flaw::wording},
       .check = antipodal_matrix,
       .paper_at_witness = transpose_at_witness,
       .steps = {"opposite-rotations", "adjugate-rotation", "adjugate-eigenvector",
                 "asymmetric-antipode"}},
  };
}

}  // namespace tensortopo::theory
