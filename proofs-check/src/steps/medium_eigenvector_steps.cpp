// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What the first theorem concludes: which points belong to v, and to -v.
#include <array>

#include "certificates/step.hpp"
#include "steps/common/asymmetric_tensor.hpp"
#include "steps/common/general_matrices.hpp"

namespace proofs {
namespace {

/// Turned by plus and minus pi/2.
Matrix2 quarter_turn(int sign) { return AsymmetricTensor::rotation(0, sign); }

std::vector<Polynomial> adjugate_by_rotation(Constants& k) {
  const Matrix2 m = any_matrix();
  const Matrix2 turned = quarter_turn(-1) * transpose(m) * quarter_turn(1);
  return entries(turned - isotropic<2>(k(1)) * adjugate(m));
}

std::vector<Polynomial> adjugate_by_trace(Constants& k) {
  const Matrix2 m = any_matrix();
  return entries(adjugate(m) - (isotropic<2>(k(1) * trace(m)) - m));
}

/// A with the half angle of theta of cosine 12/13 and sine 5/13 for T' = [[1, 0], [0, 0]]: its
/// eigenvectors are (7, 17) of eigenvalue 119/169 and (-7, 17) of eigenvalue 0.
struct ExampleTensor {
  Matrix2 a, opposite;

  ExampleTensor() {
    const AsymmetricTensor general;
    const Matrix2 t{{{1, 0}, {0, 0}}};
    const auto at_angle = [&](Matrix2 m) {
      for (auto& row : m)
        for (Polynomial& entry : row)
          entry = entry.with_square("r", general.half)
                      .with("h", rational(12, 13))
                      .with("g", rational(5, 13));
      return m;
    };
    a = at_angle(general.of(t));
    opposite = at_angle(general.opposite_of(t));
  }
};

void opposite_is_turned_transpose(Checks& c) {
  const AsymmetricTensor a;
  const Matrix2 opposite = a.opposite_of(restricted());
  const Matrix2 turned = quarter_turn(-1) * transpose(a.of(restricted())) * quarter_turn(1);
  for (const Polynomial& f : entries(opposite - isotropic<2>(c.k(1)) * turned))
    c.vanishes(a.reduced(f));
}

void opposite_is_not_transpose(Checks& c) {
  const ExampleTensor example;
  c.equal(example.opposite[0][1], c.k(-49, 338));
  c.equal(example.a[1][0], c.k(289, 338));
  c.differ(example.opposite[0][1], transpose(example.a)[0][1]);
}

void adjugate_keeps_eigenvectors(Checks& c) {
  // A v = l v has (tr A - l) v = adj(A) v: the other eigenvalue, on the same eigenvector.
  const Matrix2 m = any_matrix();
  const Vector2 v{variable("vx"), variable("vy")};
  const auto l = variable("l1");
  const Vector2 excess = m * v - l * v;
  const Vector2 claim = adjugate(m) * v - (c.k(1) * trace(m) - c.k(1) * l) * v;
  c.all_vanish({claim[0] + excess[0], claim[1] + excess[1]});
}

void adjugate_loses_orthogonal_vector(Checks& c) {
  const ExampleTensor example;
  const Vector2 v1{c.k(7), c.k(17)}, v3{-v1[1], v1[0]};
  const Vector2 excess = example.a * v1 - c.k(119, 169) * v1;
  c.all_vanish({excess[0], excess[1], determinant(example.a)});
  // The other eigenvalue is 0, but:
  const Vector2 image = adjugate(example.a) * v3;
  c.equal(image[0], c.k(-7));
  c.equal(image[1], c.k(17));
  c.differ(image[0], 0);
}

void directions_are_roots(Checks& c) {
  // p.A v for v = (x, y), p = (-y, x): a binary quadratic form, zero exactly on eigenvectors.
  const Matrix2 m = any_matrix();
  const auto x = variable("x"), y = variable("y");
  const Vector2 v{x, y}, p{-y, x};
  const Polynomial xx = m[1][0], xy = m[1][1] - m[0][0], yy = -m[0][1];
  c.vanishes(dot(p, m * v) - c.k(1) * (xx * x * x + xy * x * y + yy * y * y));
  // Its discriminant is that of A, so it has as many roots as A has real eigenvalues unless all of
  // its coefficients vanish, and then A is a multiple of I.
  c.vanishes(square(xy) - c.k(4) * xx * yy - (square(trace(m)) - c.k(4) * determinant(m)));
}

void isotropic_plane_has_all_directions(Checks& c) {
  // T-bar = diag(1, 0, -1) restricted to the plane across (1, 0, 1).
  const Matrix3 t = diagonal({c.k(1), 0, c.k(-1)});
  const Vector3 e1{0, 1, 0}, e2{1, 0, -1};
  c.all_vanish(
      {quadratic_form(t, e1), quadratic_form(t, e2), dot(e1, t * e2), trace(t), determinant(t)});
  // All tensors with (1, 0, 1) as an eigenvector are orthogonal to it: a family of them of each
  // mode, one for each direction in the plane.
  const Matrix2 zero;
  for (const Polynomial& f : entries(AsymmetricTensor().of(zero))) c.vanishes(f);
}

void isotropic_only_without_determinant(Checks& c) {
  directions_are_roots(c);
  // A = 0 means that T-bar vanishes on the plane across v, here the plane of x and y.
  c.vanishes(determinant(symmetric(0, 0, variable("zz"), 0, variable("yz"), variable("xz"))));
  // A scalar: gamma_r = 0, so sin(theta) tr T' = 0 and, for mu > 0, tr T' = 0.
  const AsymmetricTensor a;
  const Matrix2 m = a.of(restricted());
  c.vanishes(a.reduced(m[1][0] - m[0][1] - a.sine(c.k) * trace(restricted())));
}

void points_of_the_space(Checks& c) {
  // Weights c0, .., c3 of the field and a factor: the mode has the sign of c0 at its point.
  const auto l1 = variable("l1"), l2 = variable("l2"), c0 = variable("c0");
  const Vector3 t{l1, l2, -(l1 + l2)}, scaled = c0 * t;
  const auto determinant_of = [](const Vector3& d) { return d[0] * d[1] * d[2]; };
  c.vanishes(determinant_of(scaled) - c.k(1) * cube(c0) * determinant_of(t));
  c.vanishes(dot(scaled, scaled) - c.k(1) * square(c0) * dot(t, t));
}

void points_at_infinity(Checks& c) {
  // T0 = [[0,1,0],[1,0,0],[0,0,0]], Tx = diag(11,2,-13), Ty = [[0,0,0],[0,0,1],[0,1,0]],
  // Tz = diag(1,-1,0), T-bar ~ [[0,0,1],[0,0,0],[1,0,0]], and v = (0,1,0).
  const Matrix3 t0 = symmetric(0, 0, 0, 1, 0, 0), tx = diagonal({11, 2, -13}),
                ty = symmetric(0, 0, 0, 0, 1, 0), tz = diagonal({1, -1, 0}),
                bar = symmetric(0, 0, 0, 0, 0, 1);
  for (const Matrix3& t : {t0, tx, ty, tz}) c.vanishes(inner(bar, t));
  // T' in the basis (0,0,1), (1,0,0) is [[0,1],[1,0]]: A is symmetric and has two eigenvalues.
  const Matrix2 in_plane{{{bar[2][2], bar[2][0]}, {bar[0][2], bar[0][0]}}};
  const AsymmetricTensor a;
  const Matrix2 m = a.of(in_plane);
  c.equal(a.reduced(square(trace(m)) - Polynomial(4) * determinant(m)), c.k(4));
  // Yet no point of the field, where T0 has the factor 1, has the eigenvector v.
  const Vector3 v{0, 1, 0};
  Vector3 image = t0 * v;
  for (const auto& [factor, t] :
       {std::pair{variable("x"), tx}, {variable("y"), ty}, {variable("z"), tz}}) {
    const Vector3 part = t * v;
    for (std::size_t i = 0; i < 3; ++i) image[i] += factor * part[i];
  }
  c.equal(image[0], c.k(1));
}

void vectors_of_other_modes(Checks& c) {
  // T = [[4z,1,x],[1,-5z,y],[x,y,z]], T-bar ~ diag(2,1,-3), v = (0,0,1), s = 1/2.
  const Matrix3 bar = diagonal({c.k(2), c.k(1), c.k(-3)});
  for (const Matrix3& t : {symmetric(0, 0, 0, 1, 0, 0), symmetric(0, 0, 0, 0, 0, 1),
                           symmetric(0, 0, 0, 0, 1, 0), diagonal({4, -5, 1})})
    c.vanishes(inner(bar, t));
  const Vector3 v{0, 0, 1};
  const Polynomial alpha = quadratic_form(bar, v), beta = quadratic_form(bar * bar, v);
  const Polynomial boundary = Polynomial(rational(1, 2)) * inner(bar, bar) - beta +
                              rational(1, 4) * (Polynomial(1) - square(c.k(1, 2))) * square(alpha);
  c.equal(boundary, rational(-5, 16));
  // At the origin v has the medium one of the eigenvalues -1, 0, 1.
  const Matrix3 origin = symmetric(0, 0, 0, 1, 0, 0);
  for (const Vector3& e : {Vector3{1, 1, 0}, Vector3{1, -1, 0}, v}) {
    const Polynomial eigenvalue = e[0] * e[1];
    const Vector3 rest = origin * e - eigenvalue * e;
    c.all_vanish({rest[0], rest[1], rest[2]});
  }
}

void vectors_of_this_mode(Checks& c) {
  // In the basis d, v x d of the plane: T' = [[(1-s) n, y], [y, (1+s) n]].
  const auto s = variable("s"), n = variable("n"), y = variable("y");
  const Matrix2 t{{{(c.k(1) - s) * n, y}, {y, (c.k(1) + s) * n}}};
  const Polynomial delta =
      rational(1, 4) * (square(t[0][0] - t[1][1]) + Polynomial(4) * y * y - square(s * trace(t)));
  c.sum_of_squares(delta, {{c.k(1), y}});
}

}  // namespace

std::vector<Step> medium_eigenvector_steps() {
  const Place place = Place::theorem1;
  return {
      claim(place, "directions-are-roots", Kind::identity,
            "p = v turned by pi/2: p.A v is a binary quadratic form with the discriminant of A; it "
            "is zero exactly on the eigenvectors",
            directions_are_roots),
      correction(place, "points-of-isotropic-plane", Kind::identity,
                 {"v has as many points as A has real eigenvalues",
                  "so it is unless A is a multiple of I, which for mu > 0 needs A = 0 and then "
                  "det(T-bar) = 0: infinitely many points",
                  "T-bar ~ diag(1, 0, -1), v ~ (1, 0, 1): A = 0 for every mu"},
                 isotropic_only_without_determinant, isotropic_plane_has_all_directions),
      correction(place, "points-at-infinity", Kind::identity,
                 {"v has as many points in space as A has real eigenvalues",
                  "as many tensors in the span of the field; c0 t has the determinant c0^3 det t "
                  "and the squared norm c0^2 |t|^2, so a tensor of weight c0 of T0 is taken at a "
                  "point where the mode has the sign of c0, and nowhere in space if c0 = 0",
                  "T0 = [[0,1,0],[1,0,0],[0,0,0]], Tx = diag(11,2,-13), "
                  "Ty = [[0,0,0],[0,0,1],[0,1,0]], Tz = diag(1,-1,0), v = (0,1,0): A has two real "
                  "eigenvalues, but T v has the first component 1 everywhere"},
                 points_of_the_space, points_at_infinity),
      correction(place, "vectors-of-complex-domain", Kind::identity,
                 {"a vector of the complex domain is the medium eigenvector of no tensor of the "
                  "field",
                  "of no tensor of mode mu or -mu: at the medium eigenvector of one, Delta = "
                  "sigma^2 >= 0",
                  "T = [[4z,1,x],[1,-5z,y],[x,y,z]], s = 1/2, v = (0,0,1): |T-bar|^2/2 - beta + "
                  "(1-s^2) alpha^2/4 = -5/16, but T(0) has the eigenvalues -1, 0, 1 and the medium "
                  "eigenvector v"},
                 vectors_of_this_mode, vectors_of_other_modes),
      identity(place, "adjugate-rotation", "R(-pi/2) A^T R(pi/2) = adj(A)", adjugate_by_rotation),
      identity(place, "adjugate-trace", "adj(A) = tr(A) I - A", adjugate_by_trace),
      correction(place, "opposite-rotations", Kind::identity,
                 {"A with the rotations reversed, as for -v, is A^T",
                  "it is R(-pi/2) A^T R(pi/2) = adj(A)",
                  "cos(theta/2) = 12/13, sin(theta/2) = 5/13, T' = [[1,0],[0,0]]: "
                  "A = [[119,49],[289,119]]/338, reversed [[119,-49],[-289,119]]/338"},
                 opposite_is_turned_transpose, opposite_is_not_transpose),
      correction(place, "adjugate-eigenvector", Kind::identity,
                 {"A v1 = l1 v1 and v3 orthogonal to v1: adj(A) v3 = l2 v3",
                  "adj(A) v1 = (tr(A) - l1) v1 = l2 v1: the same eigenvectors, the eigenvalues "
                  "exchanged",
                  "A = [[119,49],[289,119]]/338, v1 = (7,17), v3 = (-17,7), l1 = 119/169, l2 = 0: "
                  "adj(A) v3 = (-7,17)"},
                 adjugate_keeps_eigenvectors, adjugate_loses_orthogonal_vector),
  };
}

}  // namespace proofs
