// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The quad parameterization as printed, and what the sphero-conal coordinates do in its place; the
// lines of singularities; the mode along an edge.
#include "certificates/step.hpp"
#include "steps/common/ordered_eigenvalues.hpp"

namespace proofs {
namespace {

void sphero_conal_is_a_chart(Checks& c) {
  const auto A = variable("A"), B = variable("B"), ct = variable("ct"), st = variable("st"),
             ce = variable("ce"), se = variable("se");
  const auto reduced = [](const Polynomial& f) {
    const Polynomial one(1);
    return f.with_square("st", one - square(variable("ct")))
        .with_square("se", one - square(variable("ce")))
        .with_square("B", one - square(variable("A")));
  };
  const Vector3 squares{square(ct) * (c.k(1) - square(B * ce)), square(st * se),
                        square(ce) * (c.k(1) - square(A * ct))};
  c.vanishes(reduced(squares[0] + squares[1] + squares[2] - c.k(1)));
  // y / x depends on both parameters; the roots are of positive numbers.
  c.sum_of_squares(Polynomial(1) - square(B * ce) + (square(A) + square(B) - 1) * square(ce) +
                       (square(ce) + square(se) - 1),
                   {{1, se}, {1, A * ce}});
  c.sum_of_squares(Polynomial(1) - square(A * ct) + (square(A) + square(B) - 1) * square(ct) +
                       (square(ct) + square(st) - 1),
                   {{1, st}, {1, B * ct}});
}

void printed_quads(Checks& c) {
  const auto f = variable("f"), ct = variable("ct"), ce = variable("ce"), se = variable("se");
  const Polynomial inside = c.k(1) + f * square(ce);
  const Polynomial xx = square(ct) * inside, yy = square(ct * se), zz = square(ce);
  // Without theta: one direction of the plane of x and y for each eta.
  c.vanishes(yy * inside - xx * square(se));
  // At theta = 0, eta = pi/2.
  const auto at = [](const Polynomial& g) { return g.with("ct", 1).with("ce", 0).with("se", 1); };
  c.equal(at(xx + yy + zz), c.k(2));
}

std::vector<Polynomial> printed_factor(Constants& k) {
  // f (b3 - b2) = 2 b2 - b3 - b1 and f = A^2 / B^2 - 1, times (b2 - b3)(b3 - b2).
  const OrderedEigenvalues b;
  const Polynomial numerator = k(2) * b.b2 - b.b3 - b.b1;
  const Polynomial up = b.b1 - b.b2, down = b.b2 - b.b3;
  return {numerator * down - (up - k(1) * down) * (b.b3 - b.b2)};
}

void complex_domain_by_one_factor(Checks& c) {
  // 4 Delta = F G; d+ = b2 + x and d- = b2 - y, not negative x, y and b2, and s = p / (p + q).
  const auto b2 = variable("b2"), x = variable("x"), y = variable("y"), p = variable("p"),
             q = variable("q");
  const Polynomial plus = b2 + x, minus = b2 - y;
  const Polynomial G = (c.k(2) * p + q) * plus - q * minus;
  c.equal(G, c.k(2) * p * (b2 + x) + c.k(1) * q * (x + y));
  c.positive_on_orthant(G);
}

std::vector<Polynomial> singular_lines(Constants& k) {
  // In the basis e1, e2 of the plane across a singularity: m (e1 e1^T - e2 e2^T) + n (e1 e2^T +
  // e2 e1^T). T-bar is b2 I there, with any entries beside it.
  const auto m = variable("m"), n = variable("n"), b2 = variable("b2");
  const Matrix3 t = symmetric(k(1) * m, k(-1) * m, 0, n, 0, 0);
  const Matrix3 bar =
      symmetric(k(1) * b2, k(1) * b2, variable("zz"), 0, variable("yz"), variable("xz"));
  return {trace(t), determinant(t), inner(t, bar)};
}

void mode_along_an_edge(Checks& c) {
  // N = |T|^2 of degree 2 and D = det T of degree 3 along a line: 2 N D' - 3 D N'.
  const auto x = variable("x");
  Polynomial N, D;
  for (unsigned i = 0; i <= 3; ++i) {
    if (i < 3) N += variable("n" + std::to_string(i)) * power(x, i);
    D += variable("d" + std::to_string(i)) * power(x, i);
  }
  const Polynomial condition = c.k(2) * N * D.derivative("x") - c.k(3) * D * N.derivative("x");
  c.equal(static_cast<int>(condition.coefficients_of("x").size()) - 1, 3);
}

}  // namespace

std::vector<Step> chart_steps() {
  return {
      correction(Place::quads, "quads", Kind::identity,
                 {"x = cos(theta) sqrt(f cos^2(eta) + 1), y = cos(theta) sin(eta), z = cos(eta) "
                  "covers the sphere",
                  "x = cos(theta) sqrt(1 - B^2 cos^2(eta)), y = sin(theta) sin(eta), z = cos(eta) "
                  "sqrt(1 - A^2 cos^2(theta)) does: unit vectors, and both roots real",
                  "as printed y / x does not depend on theta, and the squared length at theta = 0, "
                  "eta = pi/2 is 2"},
                 sphero_conal_is_a_chart, printed_quads),
      identity(Place::quads, "quad-factor",
               "f = (2 b2 - b3 - b1)/(b3 - b2) is A^2/B^2 - 1: the irregular points meant are the "
               "singularities",
               printed_factor),
      claim(Place::quads, "boundary-factor-sign", Kind::inequality,
            "(1+s) d+ - (1-s) d- >= 0, so the complex domain is where (1-s) d+ - (1+s) d- < 0",
            complex_domain_by_one_factor),
      identity(
          Place::theorem5, "singular-lines",
          "across a singularity T-bar is isotropic: all tensors of the plane without trace are "
          "orthogonal to it and of mode 0, a line in space",
          singular_lines),
      claim(Place::faces, "critical-on-edge", Kind::count,
            "along an edge 2 N D' - 3 D N', which has the sign of the mode's derivative, is a "
            "cubic: at most three critical points (not in the paper)",
            mode_along_an_edge),
  };
}

}  // namespace proofs
