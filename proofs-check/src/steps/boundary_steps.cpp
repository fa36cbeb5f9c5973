// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The complex domain boundary: A as the sum of an isotropic, a rotational and an anisotropic part.
#include "certificates/step.hpp"
#include "steps/common/asymmetric_tensor.hpp"
#include "steps/common/general_matrices.hpp"

namespace proofs {
namespace {

/// The factors of the parts; x and y of the third are gamma_s cos(tau) and gamma_s sin(tau).
struct Parts {
  Polynomial isotropic, rotational, anisotropic_x, anisotropic_y;

  explicit Parts(const Matrix2& m, const Polynomial& half = rational(1, 2))
      : isotropic(half * (m[0][0] + m[1][1])),
        rotational(half * (m[1][0] - m[0][1])),
        anisotropic_x(half * (m[0][0] - m[1][1])),
        anisotropic_y(half * (m[0][1] + m[1][0])) {}
  Polynomial anisotropic_squared() const { return square(anisotropic_x) + square(anisotropic_y); }
};

std::vector<Polynomial> decomposition(Constants& k) {
  const Matrix2 m = any_matrix();
  const Parts p(m, k(1, 2));
  const Matrix2 sum{{{p.isotropic + p.anisotropic_x, p.anisotropic_y - p.rotational},
                     {p.anisotropic_y + p.rotational, p.isotropic - p.anisotropic_x}}};
  return entries(sum - m);
}

std::vector<Polynomial> discriminant_of_parts(Constants& k) {
  const Matrix2 m = any_matrix();
  const Parts p(m, k(1, 2));
  return {p.anisotropic_squared() - square(p.rotational) -
          (k(1, 4) * square(trace(m)) - determinant(m))};
}

std::vector<Polynomial> rotations_add(Constants& k) {
  const AsymmetricTensor a(k(1, 2));
  const Polynomial cosine = square(a.h) - square(a.g), sine = a.sine(k);
  const Matrix2 product =
      a.rotation(a.minus_cosine, a.minus_sine) * a.rotation(a.plus_cosine, a.plus_sine);
  std::vector<Polynomial> differences;
  for (const Polynomial& f : entries(product - a.rotation(cosine, sine)))
    differences.push_back(a.reduced(f));
  return differences;
}

std::vector<Polynomial> parts_of_asymmetric_tensor(Constants& k) {
  const AsymmetricTensor a;
  const Matrix2 t = restricted();
  const Parts p(a.of(t)), of_t(t);
  const Polynomial cosine = square(a.h) - square(a.g), half_trace = k(1, 2) * trace(t);
  return {a.reduced(p.isotropic - cosine * half_trace),
          a.reduced(p.rotational - a.sine(k) * half_trace),
          a.reduced(square(p.isotropic) + square(p.rotational) - square(half_trace)),
          // gamma_s is that of T': the rotations turn it without changing its length.
          a.reduced(p.anisotropic_squared() - k(1) * of_t.anisotropic_squared()), of_t.rotational};
}

std::vector<Polynomial> magnitude_is_kept(Constants& k) {
  const AsymmetricTensor a;
  const Matrix2 t = restricted(), m = a.of(t);
  return {a.reduced(trace(transpose(m) * m) - k(1) * trace(t * t))};
}

void squared_magnitude(Checks& c) {
  const Matrix2 m = any_matrix();
  const Parts p(m, c.k(1, 2));
  c.equal(inner(m, m),
          c.k(2) * (square(p.isotropic) + square(p.rotational) + p.anisotropic_squared()));
}

void not_magnitude(Checks& c) {
  // A = I: gamma_d = 1 alone, and the squared magnitude is 2, not the square of 2.
  const Polynomial claimed = c.k(2) * 1;
  c.equal(inner(isotropic<2>(1), isotropic<2>(1)), claimed);
  c.differ(inner(isotropic<2>(1), isotropic<2>(1)), square(claimed));
}

/// A unit vector and a traceless T-bar of any norm.
struct AcrossVector : UnitVector {
  Matrix3 t = any_traceless(), projection = isotropic<3>(1), projected;

  AcrossVector() {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) projection[i][j] -= v[i] * v[j];
    projected = projection * t * projection;
  }
};

std::vector<Polynomial> projected_square(Constants& k) {
  const AcrossVector a;
  const Polynomial alpha = quadratic_form(a.t, a.v), beta = quadratic_form(a.t * a.t, a.v);
  std::vector<Polynomial> differences;
  for (const Polynomial& f : entries(a.projection * a.projection - a.projection))
    differences.push_back(AcrossVector::reduced(f));
  differences.push_back(AcrossVector::reduced(
      trace(a.projected * a.projected) - (inner(a.t, a.t) - k(2) * beta + k(1) * square(alpha))));
  return differences;
}

void boundary_with_characteristic_tensor(Checks& c) {
  // gamma_s^2 = tr(T'^2)/2 - (tr T'/2)^2 and gamma_r = -sin(theta) alpha/2, for |T-bar|^2 = 2 n.
  const auto n = variable("n"), alpha = variable("alpha"), beta = variable("beta"),
             s = variable("s");
  const Polynomial projected_squared = Polynomial(2) * n - Polynomial(2) * beta + square(alpha);
  const Polynomial anisotropic_squared = c.k(1, 2) * projected_squared - square(c.k(1, 2) * alpha);
  c.equal(anisotropic_squared, n - beta + c.k(1, 4) * square(alpha));
  c.equal(anisotropic_squared - square(c.k(1, 2) * s * alpha),
          n - beta + c.k(1, 4) * (c.k(1) - square(s)) * square(alpha));
}

void boundary_with_projection(Checks& c) {
  // v.T' v = 0 and v.T'^2 v = 0, so the printed inequality is 1/2 >= 0 for every v.
  const AcrossVector a;
  c.vanishes(AcrossVector::reduced(quadratic_form(a.projected, a.v)));
  c.vanishes(AcrossVector::reduced(quadratic_form(a.projected * a.projected, a.v)));
  // But it fails for T-bar ~ diag(2, 1, -3), v = (0, 0, 1), s = 1/2, with |T-bar|^2 = 14.
  const Polynomial alpha = c.k(-3), s = rational(1, 2);
  c.equal(
      Polynomial(7) - square(alpha) + rational(1, 4) * (Polynomial(1) - square(s)) * square(alpha),
      c.k(-5, 16));
}

std::vector<Polynomial> tensor_on_boundary(Constants& k) {
  // In the plane across v: T' = -(alpha/2) I + [[x, y], [y, -x]], x^2 + y^2 = (s alpha / 2)^2.
  const auto alpha = variable("alpha"), s = variable("s"), x = variable("x"), y = variable("y");
  const Polynomial shift = k(1, 2) * alpha * (k(1) + k(1, 3) * square(s)) - k(1, 2) * alpha;
  const Polynomial at_v = k(-1, 3) * square(s) * alpha;
  const Matrix2 across{{{x + shift, y}, {y, shift - x}}};
  const auto reduced = [&](const Polynomial& f) {
    return f.with_square("y", rational(1, 4) * square(s * alpha) - square(x));
  };
  // A multiple of (3+s, -2s, s-3), with v in the middle.
  const Polynomial factor = k(1, 6) * s * alpha;
  return {at_v + k(2) * s * factor, trace(across) - factor * (k(2) * s),
          reduced(determinant(across)) - square(factor) * (square(s) - k(9))};
}

std::vector<Polynomial> boundary_on_plane(Constants& k) {
  const AcrossVector a;
  const Matrix3 n =
      symmetric(variable("nxx"), variable("nyy"), -(variable("nxx") + variable("nyy")),
                variable("nxy"), variable("nyz"), variable("nxz"));
  const auto s = variable("s");
  const Polynomial alpha = quadratic_form(a.t, a.v), at_v = quadratic_form(n, a.v);
  const Polynomial along_projection = k(1, 2) * alpha * (k(1) + k(1, 3) * square(s));
  Matrix3 tensor = a.projected;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      tensor[i][j] +=
          along_projection * a.projection[i][j] - k(1, 3) * square(s) * alpha * a.v[i] * a.v[j];
  const Polynomial condition =
      k(2) * dot(a.v, n * (a.t * a.v)) - k(1, 2) * (k(1) - square(s)) * alpha * at_v;
  return {UnitVector::reduced(inner(n, tensor) + condition - k(1) * inner(n, a.t))};
}

/// The boundary function with each term multiplied by a power of |v|^2 to equal degrees.
Polynomial homogeneous_boundary() {
  const AcrossVector a;
  const Polynomial norm = dot(a.v, a.v), alpha = quadratic_form(a.t, a.v);
  return inner(a.t, a.t) * square(norm) - Polynomial(2) * norm * quadratic_form(a.t * a.t, a.v) +
         rational(1, 2) * (Polynomial(1) - square(variable("s"))) * square(alpha);
}

void boundary_degree(Checks& c) {
  // Homogeneous: v times a factor gives the factor's fourth power.
  const Polynomial f = homogeneous_boundary();
  const auto factor = variable("c0");
  Polynomial scaled = f;
  for (const std::string name : {"vx", "vy", "vz"})
    scaled = scaled.with(name, factor * variable(name));
  c.equal(scaled, power(factor, 4) * f);
  for (const std::string name : {"vx", "vy", "vz"})
    c.equal(static_cast<int>(f.coefficients_of(name).size()) - 1, c.k(4));
}

void boundary_degree_is_not_six(Checks& c) {
  const Polynomial f = homogeneous_boundary();
  c.differ(static_cast<int>(f.coefficients_of("vx").size()) - 1, 6);
  // It is a quadratic form in the squares of v's coordinates if T-bar is diagonal.
  const Polynomial diagonal = f.with("xy", 0).with("yz", 0).with("xz", 0);
  c.equal(diagonal.with("vx", -variable("vx")), c.k(1) * diagonal);
}

void sign_of_boundary_on_field(Checks& c) {
  // sigma = y changes its sign with the eigenvalue that belongs to d: major below, minor above.
  const AsymmetricTensor a;
  const auto n = variable("n"), y = variable("y");
  const Polynomial s = Polynomial(2) * a.g * a.h;
  const Matrix2 m = a.of({{{(c.k(1) - s) * n, y}, {y, (c.k(1) + s) * n}}});
  c.vanishes(a.reduced(m[1][0]));
  c.vanishes(a.reduced(m[0][0] - c.k(1, 2) * trace(m) + c.k(1) * y));
}

void boundary_along_mode_curve(Checks& c) {
  sign_of_boundary_on_field(c);
  const auto s = variable("s"), n = variable("n"), y = variable("y");
  const Polynomial first = (c.k(1) - s) * n, second = (c.k(1) + s) * n;
  const Polynomial delta =
      rational(1, 4) * (square(first - second) - square(s * (first + second))) + square(y);
  c.sum_of_squares(delta, {{c.k(1), y}});
}

}  // namespace

std::vector<Step> boundary_steps() {
  const Place place = Place::theorem2;
  return {
      identity(place, "decomposition",
               "A = gamma_d I + gamma_r J + gamma_s [[cos tau, sin tau], [sin tau, -cos tau]] with "
               "gamma_d = tr(A)/2, gamma_r = (a21 - a12)/2, gamma_s (cos tau, sin tau) = "
               "(a11 - a22, a12 + a21)/2",
               decomposition),
      identity(place, "decomposition-discriminant", "gamma_s^2 - gamma_r^2 = (tr A)^2 / 4 - det A",
               discriminant_of_parts),
      identity(place, "rotations-add", "R(theta/2 - pi/4) R(theta/2 + pi/4) = R(theta)",
               rotations_add),
      identity(place, "parts-of-asymmetric-tensor",
               "gamma_d = cos(theta) tr(T')/2, gamma_r = sin(theta) tr(T')/2, so gamma_d^2 + "
               "gamma_r^2 = (tr T'/2)^2; gamma_s is that of T'",
               parts_of_asymmetric_tensor),
      identity(place, "magnitude-kept", "tr(A^T A) = tr(T'^2)", magnitude_is_kept),
      correction(place, "squared-magnitude", Kind::identity,
                 {"the magnitude of A is 2 (gamma_d^2 + gamma_r^2 + gamma_s^2)",
                  "the squared magnitude tr(A^T A) is",
                  "A = I: gamma_d = 1 is the only part, and tr(A^T A) = 2"},
                 squared_magnitude, not_magnitude),
      identity(place, "projected-square",
               "|v| = 1, P = I - v v^T: P^2 = P and tr((P T P)^2) = |T|^2 - 2 v.T^2 v + (v.T v)^2",
               projected_square),
      correction(
          place, "real-domain", Kind::identity,
          {"the real domain is 1/2 - v.T'^2 v + cos^2(theta) (v.T' v)^2 / 4 >= 0 for the "
           "projected T' of T-bar",
           "with T-bar: gamma_s^2 = 1/2 - beta + alpha^2/4 and gamma_s^2 - gamma_r^2 = 1/2 - "
           "beta + cos^2(theta) alpha^2/4, alpha = v.T-bar v, beta = v.T-bar^2 v",
           "v.T' v = v.T'^2 v = 0, so no v would be in the complex domain; T-bar ~ "
           "diag(2,1,-3), s = 1/2, v = (0,0,1): |T-bar|^2/2 - beta + (1-s^2) alpha^2/4 = "
           "-5/16"},
          boundary_with_characteristic_tensor, boundary_with_projection),
      correction(
          place, "boundary-degree", Kind::count,
          {"the complex domain boundary is given by a polynomial of degree six",
           "of degree four in v, made homogeneous by |v|^2",
           "the degree of |v|^4 |T|^2 - 2 |v|^2 v.T^2 v + cos^2(theta) (v.T v)^2 / 2 in each "
           "coordinate is 4, and it is even in each if T-bar is diagonal"},
          boundary_degree, boundary_degree_is_not_six),
      identity(Place::faces, "tensor-on-boundary",
               "Delta(v) = 0: P T-bar P + (alpha/2)(1 + s^2/3) P - (s^2/3) alpha v v^T has the "
               "eigenvalues (3+s, -2s, s-3) times s alpha / 6, the medium one on v (not in the "
               "paper)",
               tensor_on_boundary),
      identity(Place::faces, "boundary-on-plane",
               "N traceless and orthogonal to T-bar: that tensor is orthogonal to N where 2 v.N "
               "T-bar v = cos^2(theta) (v.T-bar v)(v.N v) / 2 (not in the paper)",
               boundary_on_plane),
      claim(Place::faces, "boundary-crossing", Kind::identity,
            "along a mode curve the boundary function is sigma^2, sigma = d.T-bar (v x d): its "
            "roots there are double; sigma itself changes its sign, as the eigenvalue of A on d is "
            "tr(A)/2 - sigma",
            boundary_along_mode_curve),
  };
}

}  // namespace proofs
