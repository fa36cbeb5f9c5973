// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// How far the signed Lode angle f = arcsin(mode) / 3 moves if a deviator D becomes D' with
// |D - D'| <= e < |D|: by arcsin(e / |D|) at most.
#include "algebra/matrix.hpp"
#include "certificates/step.hpp"

namespace proofs {
namespace {

/// Deviators as vectors of five coordinates.
struct Pair {
  Vector<5> d, e;

  Pair() {
    for (std::size_t i = 0; i < 5; ++i) {
      d[i] = variable("d" + std::to_string(i));
      e[i] = variable("e" + std::to_string(i));
    }
  }
  Polynomial distance_squared() const { return dot(d - e, d - e); }
};

std::vector<Polynomial> angle_is_acute(Constants& k) {
  const Pair p;
  return {k(2) * dot(p.d, p.e) - (dot(p.d, p.d) + dot(p.e, p.e) - p.distance_squared())};
}

void sine_of_angle(Checks& c) {
  // |D - D'|^2 |D'|^2 - |D|^2 |D'|^2 sin^2 = (|D'|^2 - <D, D'>)^2.
  const Pair p;
  const Polynomial product = dot(p.d, p.e), size = dot(p.e, p.e);
  const Polynomial sine = dot(p.d, p.d) * size - square(product);
  c.sum_of_squares(p.distance_squared() * size - sine, {{c.k(1), size - product}});
}

/// Eigenvalues of mode parameter s, of either sign: 3 (1, 0, -1) + s (1, -2, 1).
Vector3 eigenvalues_of(Constants& k, const Polynomial& s) {
  return {k(3) + s, k(-2) * s, s - k(3)};
}

void polar_angle(Checks& c) {
  const auto s = variable("s"), t = variable("t");
  const Vector3 a = eigenvalues_of(c.k, s), b = eigenvalues_of(c.k, t);
  // The two directions are orthogonal, of norms sqrt(2) and sqrt(6): tan f = s / sqrt(3).
  const Vector3 first{1, 0, -1}, second{1, -2, 1};
  c.vanishes(dot(first, second));
  c.equal(dot(first, first), c.k(2));
  c.equal(dot(second, second), c.k(6));
  c.equal(dot(a, b), c.k(18) + c.k(6) * s * t);
  // The sine of f - g, squared, times the norms.
  c.equal(dot(a, a) * dot(b, b) - square(dot(a, b)), c.k(108) * square(s - t));
}

std::vector<Polynomial> nearest_is_attained(Constants& k) {
  // D' the point of the ray of E nearest to D, times <E, E>: D E-parts of the distance squared.
  const Pair p;
  const Polynomial product = dot(p.d, p.e), size = dot(p.e, p.e);
  const Vector<5> rest = size * p.d - product * p.e;
  return {dot(rest, rest) - k(1) * size * (size * dot(p.d, p.d) - square(product))};
}

Polynomial determinant_of(const Vector3& values) { return values[0] * values[1] * values[2]; }

void opposite_within_reach(Checks& c) {
  // -m D is (1 + m) |D| away, for every m > 0, and has the opposite mode.
  const auto m = variable("m");
  const Vector3 d{variable("d0"), variable("d1"), variable("d2")};
  const Vector3 opposite = (c.k(-1) * m) * d;
  c.equal(dot(d - opposite, d - opposite), square(c.k(1) + m) * dot(d, d));
  c.equal(determinant_of(opposite), c.k(-1) * cube(m) * determinant_of(d));
}

void radius_is_kept_between(Checks& c) {
  // |sum w_i (D_i - D'_i)| <= sum w_i e_i: here with two vertices of weights p/(p+q) and q/(p+q);
  // the square of the sum of norms less that of the norm is 2 p q (|x| |y| - <x, y>).
  const auto p = variable("p"), q = variable("q"), x = variable("x"), y = variable("y"),
             product = variable("xy"), gap = variable("gap");
  const Polynomial of_norms = square(p * x + q * y),
                   of_sum = square(p * x) + square(q * y) + c.k(2) * p * q * product;
  // Cauchy: x y = <x, y> + gap, gap >= 0.
  const Polynomial excess = (of_norms - of_sum).with("xy", x * y - gap);
  c.equal(excess, c.k(2) * p * q * gap);
  c.positive_on_orthant(excess);
}

void relative_radius_fails_between(Checks& c) {
  // Ends 10 A and -10 A with A = diag(2,-1,-1); changed by a tenth to 11 A and -9 A. At the weight
  // 21/40 of the second end -A/2 becomes A/2: mode -1 becomes mode 1.
  const Vector3 a{2, -1, -1};
  const Polynomial w = c.k(21, 40), rest = Polynomial(1) - w;
  const Polynomial before = c.k(10) * rest - c.k(10) * w, after = c.k(11) * rest - c.k(9) * w;
  c.equal(before, c.k(-1, 2));
  c.equal(after, c.k(1, 2));
  c.is_negative(determinant_of(before * a));
  c.is_positive(determinant_of(after * a));
}

}  // namespace

std::vector<Step> stability_steps() {
  const Place place = Place::stability;
  return {
      identity(place, "perturbed-acute",
               "2 <D, D'> = |D|^2 + |D'|^2 - |D - D'|^2: positive if |D - D'| < |D|",
               angle_is_acute),
      claim(place, "perturbed-angle", Kind::inequality,
            "|D'|^2 |D - D'|^2 - (|D|^2 |D'|^2 - <D, D'>^2) is a square: the sine of the angle "
            "between D and D' is at most |D - D'| / |D|",
            sine_of_angle),
      claim(place, "signed-lode-angle", Kind::identity,
            "the eigenvalues (3+s, -2s, s-3), s of either sign, have the polar angle f with "
            "tan f = s / sqrt(3), a third of the arc sine of the mode; sin^2 of the difference of "
            "two is 108 (s - t)^2 over the product of the squared norms",
            polar_angle),
      identity(place, "perturbed-attained",
               "E on the eigenvectors of D: the point of the ray of E that is nearest to D has "
               "the distance |D| sin(f - g), so the bound is attained",
               nearest_is_attained),
      claim(place, "perturbed-isotropic", Kind::identity,
            "-m D, m > 0, is (1 + m) |D| from D and has the opposite mode: for e > |D| there is "
            "no bound",
            opposite_within_reach),
      claim(place, "perturbed-between", Kind::inequality,
            "deviators changed by at most e_i at the vertices change by at most the interpolated "
            "e_i between them (two vertices; repeat for more)",
            radius_is_kept_between),
      correction(place, "perturbed-relative", Kind::inequality,
                 {"changed by at most r |D_i| at the vertices, they change by at most r |D| "
                  "between them",
                  "at most by the interpolated r |D_i|, which can be more than |D|",
                  "ends 10 A and -10 A, A = diag(2,-1,-1), become 11 A and -9 A, a tenth each: at "
                  "the weight 21/40 -A/2 becomes A/2, mode -1 mode 1"},
                 radius_is_kept_between, relative_radius_fails_between),
  };
}

}  // namespace proofs
