// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// From a tensor of the field, in its eigenvectors v1, v2, v3, to the asymmetric tensor A: the
// vectors u = k v1 + l v3 and w = k v1 - l v3, and the condition that T-bar u is orthogonal to w.
#include "certificates/step.hpp"
#include "steps/common/asymmetric_tensor.hpp"
#include "steps/common/general_matrices.hpp"
#include "steps/common/rotation.hpp"

namespace proofs {
namespace {

std::vector<Polynomial> trace_in_frame(Constants& k) {
  const Matrix3 t = any_symmetric(), frame = rotation_times_norm();
  Polynomial sum;
  for (std::size_t i = 0; i < 3; ++i) sum += quadratic_form(t, column(frame, i));
  return {sum - k(1) * trace(t) * square(quaternion_norm())};
}

std::vector<Polynomial> inner_in_frame(Constants& k) {
  const Matrix3 t = any_symmetric(), frame = rotation_times_norm();
  const Vector3 eigenvalues{variable("l1"), variable("l2"), variable("l3")};
  Matrix3 field_tensor;
  Polynomial sum;
  for (std::size_t n = 0; n < 3; ++n) {
    const Vector3 v = column(frame, n);
    sum += eigenvalues[n] * quadratic_form(t, v);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) field_tensor[i][j] += eigenvalues[n] * v[i] * v[j];
  }
  return {inner(t, field_tensor) - k(1) * sum};
}

std::vector<Polynomial> combined_condition(Constants& k) {
  const auto l1 = variable("l1"), l2 = variable("l2"), l3 = variable("l3");
  const auto a1 = variable("a1"), a3 = variable("a3");
  const Polynomial a2 = -(a1 + a3);
  return {l1 * a1 + l2 * a2 + l3 * a3 - (k(1) * (l1 - l2) * a1 - k(1) * (l2 - l3) * a3)};
}

/// In the frame with v3 horizontal and v1 vertical, and l^2 = 1 - k^2.
struct UnitPair {
  Polynomial k = variable("k"), l = variable("l");
  Vector2 u{l, k}, w{-l, k};

  static Polynomial reduced(const Polynomial& f) {
    return f.with_square("l", Polynomial(1) - square(variable("k")));
  }
};

std::vector<Polynomial> unit_pair(Constants& k) {
  // All times l1 - l3, so that k^2 and l^2 become differences of eigenvalues.
  const auto l1 = variable("l1"), l2 = variable("l2"), l3 = variable("l3");
  const UnitPair pair;
  const auto scaled = [&](const Polynomial& f) {
    return f.with_square("k", l1 - l2).with_square("l", l2 - l3);
  };
  return {scaled(dot(pair.u, pair.u)) - k(1) * (l1 - l3),
          scaled(dot(pair.w, pair.w)) - k(1) * (l1 - l3),
          scaled(dot(pair.u, pair.w)) - (l1 + l3 - k(2) * l2)};
}

std::vector<Polynomial> sine_of_theta(Constants& k) {
  // A unit tensor: q = sqrt(2/3), w = sqrt(3), S and C of the angle arcsin(mu) / 3.
  const auto S = variable("S"), C = variable("C"), q = variable("q"), w = variable("w");
  const Polynomial half(rational(1, 2));
  const Polynomial l1 = half * q * (S + w * C), l2 = -q * S, l3 = half * q * (S - w * C);
  const Polynomial numerator = l1 + l3 - k(2) * l2, gap = l1 - l3;
  const auto reduced = [](const Polynomial& f) {
    return f.with_square("q", rational(2, 3))
        .with_square("w", 3)
        .with_square("C", Polynomial(1) - square(variable("S")));
  };
  // sqrt(6) = 3 q.
  return {l1 + l2 + l3,
          numerator + k(3) * l2,
          numerator - k(3) * q * S,
          reduced(square(gap) - (k(2) - k(3) * square(l2))),
          reduced(square(gap) - k(2) * C * C),
          reduced(numerator * C - k(1) * w * S * gap)};
}

std::vector<Polynomial> turned_pair(Constants& k) {
  const UnitPair pair;
  const Polynomial sine = square(pair.k) - square(pair.l), cosine = k(2) * pair.k * pair.l;
  // By pi/2 - theta, whose cosine and sine are the sine and cosine of theta.
  const Vector2 turned = AsymmetricTensor::rotation(sine, cosine) * pair.u;
  return {UnitPair::reduced(turned[0] - k(1) * pair.w[0]),
          UnitPair::reduced(turned[1] - k(1) * pair.w[1]),
          UnitPair::reduced(square(sine) + square(cosine) - k(1))};
}

std::vector<Polynomial> perpendicular_pair(Constants& k) {
  const UnitPair pair;
  const Matrix2 t = restricted();
  const Polynomial at_v3 = t[0][0], at_v1 = t[1][1];
  return {dot(pair.w, t * pair.u) -
          (k(1) * square(pair.k) * at_v1 - k(1) * square(pair.l) * at_v3)};
}

std::vector<Polynomial> half_angles(Constants& k) {
  const AsymmetricTensor a(k(1, 2));
  const Vector2 v1{Polynomial(), Polynomial(1)};
  const Vector2 u = a.rotation(a.minus_cosine, a.minus_sine) * v1;
  const Vector2 w = a.rotation(a.minus_cosine, -a.minus_sine) * v1;
  return {u[0] + k(1) * w[0], u[1] - k(1) * w[1], a.reduced(dot(u, u) - k(1)),
          a.reduced(dot(u, w) - a.sine(k))};
}

std::vector<Polynomial> major_is_eigenvector(Constants& k) {
  const AsymmetricTensor a;
  const Vector2 v1{Polynomial(), Polynomial(1)}, v3{Polynomial(1), Polynomial()};
  const Polynomial of_v3 = a.r * (a.h - a.g);
  const Polynomial of_v1 = a.r * (a.h + a.g);
  const Vector2 u{of_v3, of_v1}, w{-of_v3, of_v1};
  return {a.reduced(dot(v3, a.of(restricted()) * v1) + k(1) * dot(w, restricted() * u))};
}

std::vector<Polynomial> minor_is_eigenvector(Constants& k) {
  // v1 horizontal and v3 vertical; u = k v1 + l v3, and l is now the larger factor.
  const AsymmetricTensor a;
  const Vector2 v1{Polynomial(1), Polynomial()}, v3{Polynomial(), Polynomial(1)};
  const Polynomial of_v3 = a.r * (a.h + a.g);
  const Polynomial of_v1 = a.r * (a.h - a.g);
  const Vector2 u{of_v1, of_v3}, w{-of_v1, of_v3};
  const Matrix2 t = restricted();
  return {a.reduced(dot(u, u) - k(1)), a.reduced(dot(u, w) - a.sine(k)),
          dot(w, t * u) - (k(1) * square(of_v3) * t[1][1] - k(1) * square(of_v1) * t[0][0]),
          a.reduced(dot(v1, a.of(t) * v3) + k(1) * dot(w, t * u))};
}

void major_from_minor(Checks& c) {
  const AsymmetricTensor a;
  const Vector2 v3{Polynomial(1), Polynomial()};
  const Matrix2 quarter = a.rotation(0, c.k(1));
  c.equal((quarter * v3)[0], 0);
  c.equal((quarter * v3)[1], 1);
  // The vector that the next step needs changes its sign, so what is orthogonal stays so.
  const Vector2 used = a.rotation(a.minus_cosine, -a.minus_sine) * (quarter * v3);
  const Vector2 printed = a.rotation(a.plus_cosine, -a.plus_sine) * v3;
  c.all_vanish({used[0] + c.k(1) * printed[0], used[1] + c.k(1) * printed[1]});
}

void major_is_not_turned_back(Checks& c) {
  const Vector2 turned = AsymmetricTensor::rotation(0, -1) * Vector2{1, 0};
  c.equal(turned[1], c.k(-1));
  c.differ(turned[1], 1);
}

std::vector<Polynomial> eigenvectors_in_a_plane(Constants& k) {
  const Matrix2 m = any_matrix();
  const Vector2 v{variable("vx"), variable("vy")}, p{-v[1], v[0]};
  const Vector2 image = m * v;
  const Vector2 rest = dot(v, v) * image - k(1) * dot(v, image) * v - k(1) * dot(p, image) * p;
  return {rest[0], rest[1]};
}

std::vector<Polynomial> eigenvalue_cases(Constants& k) {
  const Matrix2 m = any_matrix();
  const Matrix2 rest = m - isotropic<2>(k(1, 2) * trace(m));
  const Polynomial discriminant = k(1, 4) * square(trace(m)) - determinant(m);
  return entries(rest * rest - isotropic<2>(discriminant));
}

}  // namespace

std::vector<Step> frame_steps() {
  const Place place = Place::theorem1;
  return {
      identity(place, "trace-in-frame",
               "the numbers v_i.T v_i of an orthonormal frame have sum tr T, so 0 for T-bar",
               trace_in_frame),
      identity(place, "inner-in-frame",
               "t of eigenvalues l_i on v_i: <T, t> is the sum of l_i v_i.T v_i", inner_in_frame),
      identity(place, "combined-condition",
               "a1 + a2 + a3 = 0: l1 a1 + l2 a2 + l3 a3 = (l1-l2) a1 - (l2-l3) a3",
               combined_condition),
      identity(place, "unit-pair",
               "k^2 = (l1-l2)/(l1-l3), l^2 = (l2-l3)/(l1-l3): u = k v1 + l v3 and w = k v1 - l v3 "
               "are unit vectors, and u.w = (l1+l3-2 l2)/(l1-l3)",
               unit_pair),
      identity(place, "sine-of-theta",
               "a unit tensor of mode mu, f = arcsin(mu)/3: l1+l3-2 l2 = -3 l2 = sqrt(6) sin f, "
               "(l1-l3)^2 = 2 - 3 l2^2 = 2 cos^2 f, and their quotient is sqrt(3) tan f",
               sine_of_theta),
      identity(place, "turned-pair",
               "w is u turned counterclockwise by pi/2 - theta, sin(theta) = k^2 - l^2, "
               "cos(theta) = 2 k l",
               turned_pair),
      identity(place, "perpendicular-pair",
               "w.T' u = k^2 v1.T' v1 - l^2 v3.T' v3 for each symmetric T'", perpendicular_pair),
      identity(place, "half-angles",
               "v1 turned by theta/2 - pi/4 and by pi/4 - theta/2 are unit vectors u and w, mirror "
               "images in v1, with u.w = sin(theta)",
               half_angles),
      correction(place, "major-from-minor", Kind::identity,
                 {"v3 horizontal, v1 vertical: v1 is v3 turned by -pi/2",
                  "v1 is v3 turned by +pi/2; the vector used next only changes its sign",
                  "(1, 0) turned by -pi/2 is (0, -1)"},
                 major_from_minor, major_is_not_turned_back),
      identity(place, "major-is-eigenvector",
               "mode +mu: v3.A v1 = -w.T' u, so v1 is an eigenvector of A if and only if t is "
               "orthogonal to T-bar",
               major_is_eigenvector),
      identity(place, "minor-is-eigenvector",
               "mode -mu, v1 horizontal, v3 vertical, w = -k v1 + l v3: u.w = sin(theta), "
               "w.T' u = l^2 v3.T' v3 - k^2 v1.T' v1 and v1.A v3 = -w.T' u",
               minor_is_eigenvector),
      identity(place, "eigenvectors-in-plane",
               "p = v turned by pi/2: |v|^2 A v = (v.A v) v + (p.A v) p, so v is an eigenvector if "
               "p.A v = 0",
               eigenvectors_in_a_plane),
      identity(place, "eigenvalue-cases",
               "(A - (tr A / 2) I)^2 = Delta I with Delta = (tr A)^2 / 4 - det A: no, one or two "
               "real eigenvalues as Delta is negative, zero or positive",
               eigenvalue_cases),
  };
}

}  // namespace proofs
