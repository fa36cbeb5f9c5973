// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Critical points of the mode among all tensors orthogonal to T-bar, and to N1 and N2.
#include "certificates/step.hpp"
#include "steps/common/general_matrices.hpp"
#include "steps/common/ordered_eigenvalues.hpp"
#include "steps/common/rotation.hpp"

namespace proofs {
namespace {

/// The differences of eigenvalues: traceless and orthogonal to T-bar.
Vector3 saddle_of(const Vector3& b) { return {b[1] - b[2], b[2] - b[0], b[0] - b[1]}; }

std::vector<Polynomial> saddle_is_critical(Constants& k) {
  // D^2 - l D - n I = kappa T-bar, times |D|^2.
  const OrderedEigenvalues b;
  const Vector3 bar = b.all(), d = saddle_of(b.all());
  const Polynomial norm = dot(d, d), product = d[0] * d[1] * d[2];
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i)
    differences.push_back(norm * square(d[i]) - k(3) * product * d[i] - k(1, 3) * square(norm) -
                          k(-27) * bar[0] * bar[1] * bar[2] * bar[i]);
  return differences;
}

std::vector<Polynomial> only_commuting(Constants& k) {
  // For a diagonal t: if t is traceless and orthogonal to T-bar the right side is zero.
  const OrderedEigenvalues b;
  const Vector3 t{variable("l1"), variable("l2"), variable("l3")}, bar = b.all();
  const Vector3 left = cross(t, saddle_of(b.all()));
  const Polynomial sum = t[0] + t[1] + t[2], product = dot(t, bar);
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i)
    differences.push_back(left[i] - (k(1) * sum * bar[i] - k(1) * product));
  return differences;
}

void signature_of_saddle(Checks& c) {
  // D + e X with X = x E12 + y E23 + z E13, which are the directions orthogonal to T-bar and D.
  const OrderedEigenvalues b;
  const Vector3 d = saddle_of(b.all());
  const auto e = variable("e"), x = variable("x"), y = variable("y"), z = variable("z");
  const Matrix3 t = symmetric(d[0], d[1], d[2], e * x, e * y, e * z);
  const auto determinant_powers = determinant(t).coefficients_of("e");
  const auto norm_powers = inner(t, t).coefficients_of("e");
  c.all_vanish({determinant_powers[1], norm_powers[1]});
  // The mode is det |.|^-3, whose second-order part is, times |D|^5,
  const Polynomial second =
      norm_powers[0] * determinant_powers[2] - c.k(3, 2) * determinant_powers[0] * norm_powers[2];
  // a diagonal form in x, y, z: a product for each.
  const Polynomial d1 = d[0], d3 = d[2];
  const Polynomial of_y = c.k(-1) * d1 * (c.k(2) * d1 + d3) * (d1 - d3),
                   of_x = c.k(1) * d3 * (c.k(2) * d3 + d1) * (d1 - d3),
                   of_z = c.k(1) * (d1 + d3) * (c.k(2) * d1 + d3) * (d1 + c.k(2) * d3);
  c.equal(second, of_x * x * x + of_y * y * y + of_z * z * z);
  c.negative_on_orthant(of_y);
  c.positive_on_orthant(of_x);
  c.positive_on_orthant(of_z);
}

void bifurcation_example(Checks& c) {
  // T-bar ~ diag(5, 3, -8) and D = diag(11, -13, 2), with s0 = 1/4.
  const Vector3 bar{c.k(5), c.k(3), c.k(-8)}, d = saddle_of(bar);
  c.all_vanish({d[0] - c.k(11), d[1] - c.k(-13), d[2] - c.k(2), bar[0] + bar[1] + bar[2]});
  c.equal((bar[0] + bar[1]) * c.k(1, 4), bar[0] - bar[1]);
  const auto squared_determinant = [](const Vector3& t) {
    return Polynomial(54) * square(t[0] * t[1] * t[2]);
  };
  const Polynomial mu0 = c.k(143, 343), bar6 = cube(dot(bar, bar));
  c.equal(squared_determinant(d), square(mu0) * cube(dot(d, d)));
  c.equal(squared_determinant(bar), bar6 - square(mu0) * bar6);
}

/// Traceless, in its eigenvectors.
struct Commuting {
  Vector3 n{variable("b1"), variable("b2"), -(variable("b1") + variable("b2"))};
  Polynomial n2 = dot(n, n);
  Polynomial n3 = cube(n[0]) + cube(n[1]) + cube(n[2]);
};

/// Of n2 T^2 - l (T + n3 N): what its trace leaves.
Polynomial isotropic_part(const Commuting& c, Constants& k) {
  Polynomial norm;
  for (const Polynomial& n : c.n)
    norm += square(c.n2 * square(n) - rational(1, 3) * square(c.n2) - c.n3 * n);
  return k(1, 3) * c.n2 * norm;
}

std::vector<Polynomial> critical_multiplier(Constants& k) {
  // T = n2 N^2 - (n2^2/3) I - n3 N: n2 T^2 - l (T + n3 N) is isotropic.
  const Commuting c;
  Vector3 rest;
  for (std::size_t i = 0; i < 3; ++i) {
    const Polynomial t = c.n2 * square(c.n[i]) - k(1, 3) * square(c.n2) - k(1) * c.n3 * c.n[i];
    const Polynomial l = k(1) * square(c.n3) - k(1, 6) * cube(c.n2);
    rest[i] = c.n2 * square(t) - l * (t + k(1) * c.n3 * c.n[i]) - isotropic_part(c, k);
  }
  return {rest[0], rest[1], rest[2]};
}

std::vector<Polynomial> complement_pencil(Constants& k) {
  // N = k1 N1 + k2 N2 by what enters: p_i = <N, N_i>, c_i = tr(N^2 N_i).
  const auto k1 = variable("k1"), k2 = variable("k2"), p1 = variable("p1"), p2 = variable("p2"),
             c1 = variable("c1"), c2 = variable("c2");
  const Polynomial n2 = k1 * p1 + k2 * p2, n3 = k1 * c1 + k2 * c2;
  const Polynomial cubic = c1 * p2 - c2 * p1;
  // |N|^2 <T, N_i> for T = N^2 - (|N|^2/3) I - (tr N^3/|N|^2) N.
  return {n2 * c1 - n3 * p1 - k(1) * k2 * cubic, n2 * c2 - n3 * p2 - k(-1) * k1 * cubic};
}

std::vector<Polynomial> degenerate_points(Constants& k) {
  const Vector3 e{variable("vx"), variable("vy"), variable("vz")};
  const Matrix3 n = any_traceless();
  Matrix3 t = isotropic<3>(k(-1, 3) * dot(e, e));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) t[i][j] += e[i] * e[j];
  return {trace(t), inner(t, n) - k(1) * quadratic_form(n, e)};
}

void frame_on_a_cone(Checks& c) {
  // Three orthonormal zeros of a traceless form, diag(n1, n2, n3): (1,1,1) is one.
  const OrderedEigenvalues b;
  const Vector3 n = b.all(), e{1, 1, c.k(1)};
  c.vanishes(quadratic_form(diagonal(n), e));
  // Across it the form is traceless, [[p, q], [q, -p]], and so takes opposite values at (x, y) and
  // (-y, x): two zeros at right angles.
  const auto p = variable("p"), q = variable("q"), x = variable("x"), y = variable("y");
  const Matrix2 across{{{p, q}, {q, c.k(-1) * p}}};
  const Vector2 v{x, y}, turned{-y, x};
  c.vanishes(dot(v, across * v) + dot(turned, across * turned));
  c.sum_of_squares(-determinant(across), {{c.k(1), p}, {c.k(1), q}});
  // On that frame the other form has the sum 0: it is not of one sign on the cone of the first.
  const Matrix3 frame = rotation_times_norm(), other = any_symmetric();
  Polynomial sum;
  for (std::size_t i = 0; i < 3; ++i) sum += quadratic_form(other, column(frame, i));
  c.equal(sum, c.k(1) * trace(other) * square(quaternion_norm()));
  c.vanishes(sum.with("zz", -(variable("xx") + variable("yy"))));
}

}  // namespace

std::vector<Step> saddle_steps() {
  const Place space = Place::saddle, plane = Place::theorem6;
  return {
      identity(
          space, "saddle-critical",
          "D = (b2-b3, b3-b1, b1-b2): |D|^2 D^2 - 3 det(D) D - |D|^4/3 I = -27 det(T-bar) T-bar, "
          "so D is critical among the tensors orthogonal to T-bar",
          saddle_is_critical),
      identity(space, "commuting-critical",
               "t diagonal: t x D = (tr t) T-bar - <t, T-bar> I as vectors, so a traceless t that "
               "commutes with T-bar and is orthogonal to it is a multiple of D",
               only_commuting),
      claim(space, "saddle-signature", Kind::inequality,
            "b1 > b2 > 0: the second derivative of the mode at D is negative along E23 and "
            "positive along E12 and E13, a saddle",
            signature_of_saddle),
      claim(space, "saddle-example", Kind::identity,
            "T-bar ~ diag(5, 3, -8), s0 = 1/4: D = diag(11, -13, 2), whose mode is -143/343, and "
            "1 - mode(T-bar)^2 = (143/343)^2",
            bifurcation_example),
      identity(
          plane, "critical-multiplier",
          "T = |N|^2 N^2 - |N|^4/3 I - tr(N^3) N: T^2 - l T is a multiple of N and one of I, so "
          "T is critical among the tensors orthogonal to N (not in the paper)",
          critical_multiplier),
      identity(plane, "complement-pencil",
               "N = k1 N1 + k2 N2: that T is orthogonal to N1 and N2 where the cubic tr(N^2 N1) "
               "<N,N2> - tr(N^2 N2) <N,N1> vanishes (not in the paper)",
               complement_pencil),
      identity(
          plane, "degenerate-points",
          "<e e^T - |e|^2 I/3, N> = e.N e for traceless N: a degenerate tensor is in the plane "
          "if e is a common zero of the forms of N1 and N2 (not in the paper)",
          degenerate_points),
      claim(plane, "common-zero", Kind::inequality,
            "two traceless quadratic forms have a common zero: the first has three orthonormal "
            "zeros, where the second has the sum 0, and its zeros are connected (not in the paper)",
            frame_on_a_cone),
  };
}

}  // namespace proofs
