// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Complex domains as the mode grows, and their boundary by alpha = v.T-bar v.
#include "certificates/step.hpp"
#include "steps/common/ordered_eigenvalues.hpp"

namespace proofs {
namespace {

Polynomial one() { return 1; }

void mode_grows(Checks& c) {
  // mu = s (9 - s^2) / n^3 with n^2 = 3 + s^2: its derivative times n^5.
  const auto s = variable("s");
  const Polynomial numerator = s * (Polynomial(9) - s * s), n2 = Polynomial(3) + s * s;
  const Polynomial derivative = numerator.derivative("s") * n2 - Polynomial(3) * numerator * s;
  c.equal(derivative, c.k(27) * (c.k(1) - s * s));
  c.positive_on(derivative, {"s", -1, 1});
  // From 0 to 1.
  c.vanishes(numerator.with("s", 0));
  c.equal(square(numerator).with("s", 1), c.k(1) * cube(n2).with("s", 1));
  c.is_positive(numerator.with("s", 1));
}

void domains_are_nested(Checks& c) {
  const auto s = variable("s"), more = variable("t"), alpha = variable("alpha"),
             beta = variable("beta"), n = variable("n");
  const auto at = [&](const Polynomial& sine) {
    return n - beta + c.k(1, 4) * (c.k(1) - square(sine)) * square(alpha);
  };
  const Polynomial weight = rational(1, 4) * (Polynomial(2) * s * more + square(more));
  c.equal(at(s) - at(s + more), weight * square(alpha));
  c.positive_on_orthant(weight);
}

void domains_are_properly_nested(Checks& c) {
  // The point with d+ = b2, d- = (1-s)/(1+s) b2, with all squares times W = (1+s)(b1-b3).
  const OrderedEigenvalues b;
  const auto s = variable("s"), more = variable("t");
  const Polynomial d = (c.k(1) - s) * b.b2, scale = c.k(1) + s;
  const Vector3 m{b.b1 * scale - d, 0, d - b.b3 * scale};
  const Polynomial W = scale * (b.b1 - b.b3);
  c.equal(m[0] + m[2], c.k(1) * W);
  c.positive_on_orthant(m[0]);
  c.positive_on_orthant(m[2]);
  const auto at = [&](const Polynomial& sine) {
    const Polynomial alpha = b.b1 * m[0] + b.b3 * m[2];
    const Polynomial beta = square(b.b1) * m[0] + square(b.b3) * m[2];
    return b.half_norm() * square(W) - beta * W +
           rational(1, 4) * (one() - square(sine)) * square(alpha);
  };
  c.vanishes(at(s));
  c.negative_on_orthant(at(s + more));
  c.equal(at(s + more),
          c.k(-1) * (c.k(2) * s * more + square(more)) * square(b.b2 * (b.b1 - b.b3)));
}

void domains_are_empty(Checks& c) {
  // T-bar ~ diag(1, 0, -1): no complex domain at all, whatever s is.
  const auto x = variable("x"), y = variable("y"), z = variable("z"), cosine = variable("c");
  const Vector3 m{x * x, y * y, z * z};
  const Polynomial f = boundary_function({c.k(1), 0, c.k(-1)}, m, square(cosine));
  const Polynomial unit = one() - x * x - y * y;
  c.equal(
      f.with_square("z", unit),
      (c.k(1) * square(y) + c.k(1, 4) * square(cosine * (x * x - z * z))).with_square("z", unit));
}

std::vector<Polynomial> boundary_in_squares(Constants& k) {
  const Vector3 v{variable("vx"), variable("vy"), variable("vz")};
  const OrderedEigenvalues b;
  const Matrix3 t = diagonal(b.all());
  const Polynomial cosine = variable("c");
  const Polynomial f = k(1, 2) * inner(t, t) - quadratic_form(t * t, v) +
                       k(1, 4) * square(cosine * quadratic_form(t, v));
  Vector3 m;
  for (std::size_t i = 0; i < 3; ++i) m[i] = square(v[i]);
  std::vector<Polynomial> differences{f - boundary_function(b.all(), m, square(cosine))};
  for (const std::string name : {"vx", "vy", "vz"})
    differences.push_back(f.with(name, k(-1) * variable(name)) - f);
  return differences;
}

std::vector<Polynomial> squares_of_alpha(Constants& k) {
  const OrderedEigenvalues b;
  const Vector3 eigenvalues = b.all();
  const auto alpha = variable("alpha"), cosine2 = square(variable("c"));
  const Polynomial n = b.half_norm(), beta = n + k(1, 4) * cosine2 * square(alpha);
  // The product of all differences over each denominator.
  const Vector3 cofactor{b.b2 - b.b3, b.b3 - b.b1, b.b1 - b.b2};
  const Polynomial all = (b.b1 - b.b2) * (b.b2 - b.b3) * (b.b1 - b.b3);
  Polynomial sum, sum_b, sum_b2;
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i) {
    const Polynomial& bi = eigenvalues[i];
    const Polynomial part =
        (k(1, 4) * cosine2 * square(alpha) + k(1) * bi * alpha + k(1) * square(bi)) * cofactor[i];
    sum += part;
    sum_b += bi * part;
    sum_b2 += square(bi) * part;
    const Polynomial& bj = eigenvalues[(i + 1) % 3];
    const Polynomial& bk = eigenvalues[(i + 2) % 3];
    differences.push_back((bi - bj) * (bi - bk) - (k(3) * square(bi) - n));
  }
  differences.insert(differences.end(), {sum - all, sum_b - alpha * all, sum_b2 - beta * all});
  return differences;
}

std::vector<Polynomial> square_factors(Constants& k) {
  const auto b = variable("b1"), alpha = variable("alpha"), s = variable("s");
  const Polynomial numerator = square_numerator(b, alpha, one() - square(s));
  return {k(4) * numerator - ((k(1) - s) * alpha + k(2) * b) * ((k(1) + s) * alpha + k(2) * b)};
}

void range_of_alpha(Checks& c) {
  // a = -alpha. The range is: u1, u2 and u3 are not negative.
  const OrderedEigenvalues b;
  const auto a = variable("a"), s = variable("s");
  const Polynomial u1 = (c.k(1) + s) * a - c.k(2) * b.b2, u2 = c.k(2) * b.b2 - (c.k(1) - s) * a,
                   u3 = c.k(2) * b.b1 - (c.k(1) + s) * a;
  const auto numerator = [&](const Polynomial& bi) {
    return Polynomial(4) * square_numerator(bi, -a, one() - square(s));
  };
  // m_y, m_x and m_z have these numerators over denominators of signs -, +, +.
  c.equal(numerator(b.b2), -u1 * u2);
  c.equal(numerator(b.b1), (u2 + Polynomial(2) * (b.b1 - b.b2)) * u3);
  const auto last = [&](const Polynomial& slope) { return slope * a - Polynomial(2) * b.b3; };
  c.equal(numerator(b.b3), last(one() - s) * last(one() + s));
  c.negative_on_orthant((b.b2 - b.b1) * (b.b2 - b.b3));
  c.positive_on_orthant((b.b1 - b.b2) * (b.b1 - b.b3));
  c.positive_on_orthant((b.b3 - b.b1) * (b.b3 - b.b2));
  // With s = p / (p + q), from 0 to 1: the factors of m_z are positive.
  const auto p = variable("p"), q = variable("q");
  c.positive_on_orthant(q * a - Polynomial(2) * b.b3 * (p + q));
  c.positive_on_orthant((p + p + q) * a - Polynomial(2) * b.b3 * (p + q));
  // Nothing else is allowed: u1 and u2 have the sum 2 s a, and u2 > 0 where a < 0.
  c.equal(u1 + u2, c.k(2) * s * a);
}

void alpha_without_a_point(Checks& c) {
  // T-bar ~ diag(2, 1, -3), alpha = 0: m_y is negative, whatever s is.
  const Polynomial b2 = c.k(1);
  const Polynomial denominator = (b2 - Polynomial(2)) * (b2 + Polynomial(3));
  c.equal(square_numerator(b2, 0, square(variable("c"))), c.k(-1, 4) * denominator);
  c.is_negative(denominator);
}

void alpha_determines_the_squares(Checks& c) {
  const OrderedEigenvalues b;
  const Matrix3 system{{{1, 1, 1}, b.all(), {square(b.b1), square(b.b2), square(b.b3)}}};
  const Polynomial all = (b.b1 - b.b2) * (b.b2 - b.b3) * (b.b1 - b.b3);
  c.equal(determinant(system), c.k(-1) * all);
  c.positive_on_orthant(all);
}

void alpha_is_constant(Checks& c) {
  // T-bar ~ diag(1, 1, -2): circles z = const.
  const auto x = variable("x"), y = variable("y"), z = variable("z"), s = variable("s");
  const Vector3 m{x * x, y * y, z * z}, b{c.k(1), c.k(1), c.k(-2)};
  const Polynomial alpha = b[0] * m[0] + b[1] * m[1] + b[2] * m[2];
  c.vanishes(x * alpha.derivative("y") - y * alpha.derivative("x"));
  const Polynomial f = boundary_function(b, m, one() - square(s));
  c.vanishes(x * f.derivative("y") - y * f.derivative("x"));
  // There is a boundary: at s = 1 it is z^2 = 2/3.
  const Polynomial at_one = f.with("s", 1).with_square("x", one() - y * y - z * z);
  c.equal(at_one, Polynomial(3) * (c.k(2, 3) - square(z)));
}

std::vector<Polynomial> ends_of_range(Constants& k) {
  // Each times 1 + s or 1 - s; then the sign of the difference of the two lower ends.
  const OrderedEigenvalues b;
  const auto s = variable("s");
  const auto at_end = [&](const Polynomial& bi, const Polynomial& scale) {
    const Polynomial scaled_alpha = k(-2) * bi;
    return rational(1, 4) * (one() - s * s) * square(scaled_alpha) + bi * scaled_alpha * scale +
           square(bi * scale);
  };
  const Polynomial up = b.b1 - b.b2, sum = b.b1 + b.b2;
  return {at_end(b.b2, one() + s), at_end(b.b1, one() + s), at_end(b.b2, one() - s),
          b.b1 * (k(1) - s) - b.b2 * (k(1) + s) - (up - s * sum)};
}

}  // namespace

std::vector<Step> alpha_steps() {
  const Place corollary = Place::corollary3, lemma = Place::lemma4;
  return {
      claim(corollary, "mode-grows", Kind::inequality,
            "theta grows with the mode: d mu / ds = 27 (1-s^2) / (3+s^2)^(5/2) > 0 for s^2 < 1, "
            "from mu = 0 at s = 0 to mu = 1 at s = 1",
            mode_grows),
      claim(corollary, "nested", Kind::inequality,
            "the boundary function does not grow with s: at s less at s + t it is "
            "(2 s t + t^2) alpha^2 / 4 >= 0",
            domains_are_nested),
      correction(corollary, "properly-nested", Kind::inequality,
                 {"the complex domain of the smaller mode is a proper subset",
                  "if det(T-bar) < 0: the v of d+ = b2, d- = (1-s)/(1+s) b2 is on the boundary at "
                  "s, and in the complex domain at every s + t",
                  "T-bar ~ diag(1, 0, -1): the boundary function is y^2 + cos^2(theta) (x^2 - "
                  "z^2)^2 / 4, times 1/2, so no mode has a complex domain"},
                 domains_are_properly_nested, domains_are_empty),
      identity(lemma, "boundary-in-squares",
               "with T-bar diagonal the boundary function is one of the squares of v's "
               "coordinates, so it keeps its value under each change of a sign",
               boundary_in_squares),
      identity(lemma, "squares-of-alpha",
               "m_i = (cos^2(theta) alpha^2 / 4 + b_i alpha + b_i^2) / (3 b_i^2 - |T-bar|^2 / 2): "
               "sum of m_i = 1, of b_i m_i = alpha, of b_i^2 m_i = beta, with beta from the "
               "parabola",
               squares_of_alpha),
      identity(lemma, "squares-factors",
               "4 m_i (3 b_i^2 - |T-bar|^2 / 2) = ((1-s) alpha + 2 b_i) ((1+s) alpha + 2 b_i)",
               square_factors),
      correction(lemma, "range-of-alpha", Kind::inequality,
                 {"each alpha gives a point of the boundary",
                  "each alpha from -2 min(b1/(1+s), b2/(1-s)) to -2 b2/(1+s), and no other",
                  "T-bar ~ diag(2, 1, -3), alpha = 0: m_y = -1/4"},
                 range_of_alpha, alpha_without_a_point),
      correction(lemma, "alpha-is-a-parameter", Kind::inequality,
                 {"the boundary is parameterized by alpha",
                  "if b1 > b2: alpha and beta then determine the squares, the determinant of their "
                  "linear equations being -(b1-b2)(b2-b3)(b1-b3)",
                  "T-bar ~ diag(1, 1, -2): alpha and the boundary function depend on z alone, so "
                  "the boundary is a circle on which alpha is constant (z^2 = 2/3 for mu = 1)"},
                 alpha_determines_the_squares, alpha_is_constant),
      identity(lemma, "ends-of-range",
               "m_y = 0 at -2 b2/(1+s) and at -2 b2/(1-s), m_x = 0 at -2 b1/(1+s); of the last two "
               "the first is met if s < (b1-b2)/(b1+b2), the second if s is larger",
               ends_of_range),
  };
}

}  // namespace proofs
