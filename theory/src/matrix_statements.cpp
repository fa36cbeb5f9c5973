// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The asymmetric matrix on the plane across a medium eigenvector (Theorem 1).
#include "dominant_form.hpp"
#include "groups.hpp"

namespace tensortopo::theory {
namespace {

struct Matrix {
  Rational a, b, c, d;  // rows (a, b) and (c, d)

  friend Matrix operator*(const Matrix& m, const Matrix& n) {
    return {m.a * n.a + m.b * n.c, m.a * n.b + m.b * n.d, m.c * n.a + m.d * n.c,
            m.c * n.b + m.d * n.d};
  }
  friend bool operator==(const Matrix&, const Matrix&) = default;
};

Matrix adjugate(const Matrix& m) { return {m.d, -m.b, -m.c, m.a}; }
Matrix transpose(const Matrix& m) { return {m.a, m.c, m.b, m.d}; }
Matrix swapped(const Matrix& m) { return {m.d, m.c, m.b, m.a}; }

// theta / 2 + pi / 4, an angle with rational cosine and sine; then sin(theta) is rational too.
struct Angle {
  Rational cosine, sine;

  Rational s() const { return sine * sine - cosine * cosine; }
  Matrix rotation() const { return {cosine, -sine, sine, cosine}; }
  // By theta / 2 - pi / 4, a quarter turn less.
  Matrix less_a_quarter() const { return {sine, cosine, -cosine, sine}; }
};

// t is the tangent of half the angle: from above tan(pi / 8), that is mode 0, to 1, mode 1.
Angle angle_of(const Rational& t) {
  const Rational tt = t * t, size = Rational(1) + tt;
  return {Rational((Rational(1) - tt) / size), Rational((t + t) / size)};
}

Angle random_angle(Random& random) {
  return angle_of(Rational(random.integer(10, 23)) / Rational(24));
}

Matrix restricted(const Tensor& n, const Basis& basis) {
  const Rational across = dot(basis[0], n * basis[1]);
  return {dot(basis[0], n * basis[0]), across, across, dot(basis[1], n * basis[1])};
}

Matrix asymmetric(const Tensor& n, const Basis& basis, const Angle& angle) {
  return angle.rotation() * restricted(n, basis) * angle.less_a_quarter();
}

std::string place(const Tensor& n, const Basis& basis, const Angle& angle) {
  return "characteristic tensor along " + text(n) + ", s = " + angle.s().str() + ", plane of " +
         text(basis[0]) + " and " + text(basis[1]);
}

// Both sides are quadratic forms of a direction in the plane, so three directions decide.
bool same_directions(const Matrix& a, const DominantForm& form) {
  const Rational six(6);
  return six * a.c == form.first && Rational(3) * (a.d - a.a) == form.mixed &&
         -six * a.b == form.last;
}

// Hands a check the characteristic tensor, a random basis and angle, and their matrix.
using MatrixCheck = Outcome (*)(const Tensor&, const Basis&, const Angle&, const Matrix&);

Check with_matrix(MatrixCheck check) {
  return [check](const Trial& trial) {
    const auto n = characteristic_multiple(trial.field);
    if (!n) return Outcome::not_applicable("rank below 4");
    Random random = trial.random;
    const Basis basis = random_basis(random);
    const Angle angle = random_angle(random);
    const Matrix a = asymmetric(*n, basis, angle);
    return check(*n, basis, angle, a);
  };
}

Outcome check_eigenvalue_count(const Tensor& n, const Basis& basis, const Angle& angle,
                               const Matrix& a) {
  const DominantForm form = dominant_form(n, basis, angle.s());
  const bool scalar = a.b == 0 && a.c == 0 && a.a == a.d;
  const Rational gap = (a.a - a.d) * (a.a - a.d) + Rational(4) * a.b * a.c;
  const bool as_claimed = scalar == form.is_zero() && same_directions(a, form) &&
                          sign_of(gap) == sign_of(form.discriminant());
  return as_claimed ? Outcome::holds() : Outcome::violated(place(n, basis, angle));
}

// The characteristic tensor xz vanishes on the plane across z: every direction there is dominant.
Outcome infinitely_many_points() {
  const Tensor n = {0, 0, 0, 0, 0, 1};
  const Basis basis = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const Angle angle = angle_of(Rational(Rational(1) / Rational(2)));
  const Matrix a = asymmetric(n, basis, angle);
  if (a != Matrix{} || !dominant_form(n, basis, angle.s()).is_zero()) return Outcome::holds();
  return Outcome::violated(place(n, basis, angle) +
                           ": one real eigenvalue, but a tensor for each direction of the plane");
}

Outcome check_antipode(const Tensor& n, const Basis& basis, const Angle& angle, const Matrix& a) {
  // The right-handed basis of the opposite vector, and what was found there in the first basis.
  const Basis opposite = {basis[1], basis[0], -basis[2]};
  const bool as_claimed = swapped(asymmetric(n, opposite, angle)) == adjugate(a);
  return as_claimed ? Outcome::holds() : Outcome::violated(place(n, basis, angle));
}

Outcome transpose_at_witness() {
  const Tensor n = {2, 1, -3, 0, 0, 0};
  const Basis basis = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const Angle angle = angle_of(Rational(Rational(1) / Rational(2)));
  const Matrix reversed =
      transpose(angle.rotation()) * restricted(n, basis) * transpose(angle.less_a_quarter());
  if (reversed == transpose(asymmetric(n, basis, angle))) return Outcome::holds();
  return Outcome::violated(place(n, basis, angle) +
                           ": with both rotations reversed the matrix is not the transpose");
}

}  // namespace

std::vector<Statement> matrix_statements() {
  return {
      {"medium-eigenvector-count", "Theorem 1",
       "For 0 < mu < 1, as many points of mode mu or -mu have the medium eigenvector v or -v as "
       "A(v) has real eigenvalues, and their dominant eigenvectors are eigenvectors of A(v).",
       "a field of rank 4; mu of a theta with a rational half angle, v in a rational basis",
       "Points at infinity included, in a basis with e1 x e2 = v, and unless A(v) is a multiple "
       "of the identity: then there is a point for every direction.",
       with_matrix(check_eigenvalue_count), infinitely_many_points},
      {"antipodal-matrix", "Theorem 1, end of the proof",
       "A(-v), whose rotations are reversed, is the transpose of A(v) in the same basis.",
       "a field of rank 4; mu of a theta with a rational half angle, v in a rational basis",
       "It is the adjugate: the same eigenvectors, with the two eigenvalues exchanged.",
       with_matrix(check_antipode), transpose_at_witness},
  };
}

}  // namespace tensortopo::theory
