// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Eigenvalues by the mode, the range of the mode, and the equation of a mode surface.
#include "certificates/step.hpp"
#include "steps/common/deviator.hpp"

namespace proofs {
namespace {

/// The eigenvalues of a unit tensor by the angle f, sin f = -mu / 3 tripled, as the paper has them:
/// q = sqrt(2/3), w = sqrt(3).
struct Trigonometric {
  Polynomial sine = variable("S"), cosine = variable("C"), q = variable("q"), w = variable("w");
  Polynomial l1, l2, l3;

  /// The cosine and the sine, over sqrt(3), of a third of a turn.
  Trigonometric(const Polynomial& third_cosine, const Polynomial& third_sine)
      : l1(q * (third_cosine * sine + third_sine * w * cosine)),
        l2(q * sine),
        l3(q * (third_cosine * sine - third_sine * w * cosine)) {}
  static Polynomial reduced(const Polynomial& f) {
    return f.with_square("q", rational(2, 3))
        .with_square("w", 3)
        .with_square("C", Polynomial(1) - square(variable("S")));
  }
};

std::vector<Polynomial> trigonometric_eigenvalues(Constants& k) {
  const Trigonometric t(k(-1, 2), k(1, 2));
  // 3 sqrt(6) det = 9 q det = mu = -sin(3 f).
  return {t.l1 + t.l2 + t.l3,
          Trigonometric::reduced(square(t.l1) + square(t.l2) + square(t.l3) - k(1)),
          Trigonometric::reduced(k(9) * t.q * t.l1 * t.l2 * t.l3 + k(3) * t.sine -
                                 k(4) * cube(t.sine))};
}

void ordered_eigenvalues(Checks& c) {
  // l1 - l2 and l2 - l3 are q/2 times w C -+ 3 S, whose product is positive for |S| < 1/2; so they
  // have the signs that they have at S = 0.
  const Trigonometric t(rational(-1, 2), rational(1, 2));
  const Polynomial first = t.w * t.cosine - c.k(3) * t.sine,
                   second = t.w * t.cosine + c.k(3) * t.sine;
  c.equal(c.k(2) * (t.l1 - t.l2), t.q * first);
  c.equal(c.k(2) * (t.l2 - t.l3), t.q * second);
  const Polynomial product = Trigonometric::reduced(first * second);
  c.equal(product, c.k(3) - c.k(12) * square(t.sine));
  c.positive_on(product, {"S", rational(-1, 2), rational(1, 2)});
  c.vanishes(product.with("S", c.k(1, 2)));
}

void range_of_the_mode(Checks& c) {
  // The discriminant of a deviator, free of its trace, as a sum of 13 squares.
  const Deviator d = Deviator::generic();
  const Matrix3 t = symmetric(d.a, {}, -d.b, d.xy, d.yz, d.xz), u = t * t;
  const auto difference = [](const Matrix3& m, std::size_t i) {
    const std::size_t j = (i + 1) % 3;
    return m[i][i] - m[j][j];
  };
  // 54 times the weights 1, 2 and 12.
  const Polynomial once = c.k(54), twice = c.k(108), twelvefold = c.k(648);
  std::vector<WeightedSquare> squares{
      {once, difference(t, 0) * difference(u, 1) - difference(t, 1) * difference(u, 0)}};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, other = (i + 2) % 3;
    for (std::size_t n = 0; n < 3; ++n)
      squares.push_back({twice, difference(t, n) * u[i][j] - difference(u, n) * t[i][j]});
    squares.push_back({twelvefold, t[i][j] * u[j][other] - t[j][other] * u[i][j]});
  }
  const Matrix3 traceless = tensor(d);
  const Polynomial norm = c.k(3) * inner(traceless, traceless);
  c.sum_of_squares(cube(norm) - c.k(2) * square(c.k(27) * determinant(traceless)), squares);
}

void ends_of_the_mode(Checks& c) {
  // Two equal eigenvalues l, l, -2 l: mode 1 or -1, by the sign of the third.
  const auto l = variable("l1");
  const Vector3 t{l, l, c.k(-2) * l};
  c.equal(Polynomial(54) * square(t[0] * t[1] * t[2]), cube(dot(t, t)));
  c.equal(t[0] + t[1] + t[2], 0);
  // A medium eigenvalue that is the mean of the others is zero, and so is the mode.
  const auto l1 = variable("l1"), l3 = variable("l3");
  const Polynomial l2 = -(l1 + l3);
  c.equal(l1 + l3 - c.k(2) * l2, c.k(-3) * l2);
}

void constant_mode(Checks& c) {
  // mode = m and |T| = n, so det = m n^3 / (3 r) with r = sqrt(6).
  const auto m = variable("m"), n = variable("n"), mu = variable("mu");
  const Polynomial squared_determinant = rational(1, 54) * square(m * cube(n));
  c.equal(c.k(54) * squared_determinant - c.k(1) * square(mu) * power(n, 6),
          (m - mu) * (m + mu) * power(n, 6));
}

void mode_of_the_point(Checks& c) {
  // Of eigenvalues (1, 0, -1) and mode 0, and of (2, -1, -1) and mode 1: both satisfy it.
  for (const auto& [t, mode] : {std::pair{Vector3{1, 0, -1}, c.k(0)}, {Vector3{2, -1, -1}, c.k(1)}})
    c.equal(Polynomial(54) * square(t[0] * t[1] * t[2]), square(mode) * cube(dot(t, t)));
}

}  // namespace

std::vector<Step> background_steps() {
  const Place place = Place::background;
  return {
      identity(place, "trigonometric-eigenvalues",
               "f = arcsin(-mu)/3: sqrt(2/3) times the sines of f and f +- 2 pi/3 have sum 0, "
               "squared norm 1 and mode mu",
               trigonometric_eigenvalues),
      claim(place, "eigenvalues-ordered", Kind::inequality,
            "in the order f + 2 pi/3, f, f - 2 pi/3 they descend, as |f| <= pi/6: "
            "(sqrt(3) cos f)^2 - (3 sin f)^2 = 3 - 12 sin^2 f > 0 inside",
            ordered_eigenvalues),
      claim(place, "mode-range", Kind::inequality,
            "-1 <= mode <= 1: 27 (|T|^6 - 54 det(T)^2) is 54 times a sum of 13 weighted squares",
            range_of_the_mode),
      claim(place, "mode-ends", Kind::identity,
            "two equal eigenvalues: mode +-1; the medium eigenvalue the mean of the others: it is "
            "0, and so is the mode",
            ends_of_the_mode),
      correction(place, "mode-equation", Kind::identity,
                 {"54 det(T)^2 - mu(T)^2 |T|^6 = 0, with the mode at the point, is the generalized "
                  "mode surface",
                  "with the constant mu: 54 det(T)^2 - mu^2 |T|^6 = (mode - mu)(mode + mu) |T|^6",
                  "as printed all tensors satisfy it: diag(1,0,-1) of mode 0 and diag(2,-1,-1) of "
                  "mode 1"},
                 constant_mode, mode_of_the_point),
  };
}

}  // namespace proofs
