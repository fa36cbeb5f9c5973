// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Sphero-conal coordinates of the sphere of medium eigenvectors:
//   x = cos theta sqrt(1 - B^2 cos^2 eta), y = sin theta sin eta, z = cos eta sqrt(1 - A^2 cos^2
//   theta), A^2 + B^2 = 1.
#include "algebra/matrix.hpp"
#include "certificates/step.hpp"

namespace proofs {
namespace {

struct Chart {
  Polynomial A = variable("A"), B = variable("B");
  Polynomial cos_theta = variable("ct"), sin_theta = variable("st"), cos_eta = variable("ce"),
             sin_eta = variable("se");
  /// What cos^2 + sin^2 and A^2 + B^2 are.
  Polynomial one;
  /// Squares of the coordinates.
  Vector3 squares;

  /// The last two: the ones in the roots of x and of z.
  explicit Chart(const Polynomial& sum_of_squares, const Polynomial& in_x = 1,
                 const Polynomial& in_z = 1)
      : one(sum_of_squares) {
    squares = {square(cos_theta) * (in_x - square(B * cos_eta)), square(sin_theta * sin_eta),
               square(cos_eta) * (in_z - square(A * cos_theta))};
  }
  Polynomial reduced(const Polynomial& f) const {
    return f.with_square("st", one - square(cos_theta))
        .with_square("se", one - square(cos_eta))
        .with_square("B", one - square(A));
  }
  Polynomial by_theta(const Polynomial& f) const {
    return f.derivative("st") * cos_theta - f.derivative("ct") * sin_theta;
  }
  Polynomial by_eta(const Polynomial& f) const {
    return f.derivative("se") * cos_eta - f.derivative("ce") * sin_eta;
  }
  /// 4 x^2 y^2 z^2 times the inner product of two derivatives of the point, from the derivatives u
  /// and w of the squares: dx dx' = d(x^2) d'(x^2) / (4 x^2).
  Polynomial product(const Vector3& u, const Vector3& w) const {
    return u[0] * w[0] * squares[1] * squares[2] + u[1] * w[1] * squares[0] * squares[2] +
           u[2] * w[2] * squares[0] * squares[1];
  }
  Vector3 theta_derivatives() const {
    return {by_theta(squares[0]), by_theta(squares[1]), by_theta(squares[2])};
  }
  Vector3 eta_derivatives() const {
    return {by_eta(squares[0]), by_eta(squares[1]), by_eta(squares[2])};
  }
};

/// The eigenvalues of a characteristic tensor with the medium one given, b1 - b3 = g,
/// A^2 = (b1 - b2) / g and B^2 = (b2 - b3) / g; and d+, d-.
struct ChartEigenvalues {
  Polynomial b1, b2, b3, plus, minus;

  explicit ChartEigenvalues(const Chart& c, const Polynomial& medium = variable("b2"))
      : b2(medium) {
    b1 = b2 + square(c.A) * variable("g");
    b3 = b2 - square(c.B) * variable("g");
    plus = b2 + (b1 - b2) * square(c.sin_theta);
    minus = b2 - (b2 - b3) * square(c.sin_eta);
  }
};

std::vector<Polynomial> unit_vectors(Constants& k) {
  const Chart c(k(1), k(1), k(1));
  return {c.reduced(c.squares[0] + c.squares[1] + c.squares[2] - k(1))};
}

std::vector<Polynomial> orthogonal_lines(Constants& k) {
  // In the roots any number would do.
  const Chart c(k(1));
  return {
      c.product(c.theta_derivatives(), c.eta_derivatives()).with_square("B", c.one - square(c.A))};
}

std::vector<Polynomial> metric(Constants& k) {
  const Chart c(k(1), k(1), k(1));
  const Polynomial all = k(4) * c.squares[0] * c.squares[1] * c.squares[2];
  const Polynomial numerator = square(c.A * c.sin_theta) + square(c.B * c.sin_eta);
  const Polynomial along_theta = k(1) - square(c.A * c.cos_theta);
  const Polynomial along_eta = k(1) - square(c.B * c.cos_eta);
  return {
      c.reduced(c.product(c.theta_derivatives(), c.theta_derivatives()) * along_theta -
                all * numerator),
      c.reduced(c.product(c.eta_derivatives(), c.eta_derivatives()) * along_eta - all * numerator)};
}

std::vector<Polynomial> plane_eigenvalues(Constants& k) {
  const Chart c(k(1), k(1), k(1));
  // The medium eigenvalue that makes the sum zero.
  const ChartEigenvalues b(c, k(1, 3) * (square(c.B) - square(c.A)) * variable("g"));
  const auto& [xx, yy, zz] = c.squares;
  return {c.reduced(b.plus + b.minus + k(1) * (b.b1 * xx + b.b2 * yy + b.b3 * zz)),
          c.reduced(b.plus * b.minus -
                    k(1) * (b.b2 * b.b3 * xx + b.b1 * b.b3 * yy + b.b1 * b.b2 * zz))};
}

std::vector<Polynomial> squares_of_coordinates(Constants& k) {
  const Chart c(k(1), k(1), k(1));
  const ChartEigenvalues e(c);
  const auto claim = [&](const Polynomial& b, const Polynomial& other1, const Polynomial& other2,
                         const Polynomial& v2) {
    return c.reduced(k(1) * v2 * (b - other1) * (b - other2) - (b - e.plus) * (b - e.minus));
  };
  return {claim(e.b1, e.b2, e.b3, c.squares[0]), claim(e.b2, e.b1, e.b3, c.squares[1]),
          claim(e.b3, e.b1, e.b2, c.squares[2])};
}

std::vector<Polynomial> straight_boundary(Constants& k) {
  const auto b1 = variable("b1"), b2 = variable("b2"), b3 = variable("b3"), s = variable("s"),
             X = variable("X"), Y = variable("Y");
  const Polynomial plus = b2 + (b1 - b2) * X, minus = b2 - (b2 - b3) * Y;
  const Polynomial p = (k(1) - s) * (b1 - b2), q = (k(1) + s) * (b2 - b3), c = k(2) * s * b2;
  return {(k(1) - s) * plus - (k(1) + s) * minus - (p * X + q * Y - c)};
}

std::vector<Polynomial> singular_decomposition(Constants& k) {
  // T = b2 I - (g/2) (s1 s2^T + s2 s1^T), s1 = (A, 0, B), s2 = (-A, 0, B), is diagonal.
  const Chart c(1);
  const ChartEigenvalues e(c);
  const Vector3 first{c.A, Polynomial(), c.B}, second{k(-1) * c.A, Polynomial(), c.B};
  const Vector3 expected{e.b1, e.b2, e.b3};
  const Polynomial half_gap = k(1, 2) * variable("g"), isotropic = k(1) * e.b2;
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      differences.push_back((i == j ? isotropic - expected[i] : Polynomial()) -
                            half_gap * (first[i] * second[j] + second[i] * first[j]));
  return differences;
}

std::vector<Polynomial> singular_plane(Constants& k) {
  // (I - s1 s1^T) (T - b2 I) (I - s1 s1^T) = 0 for s1 = (A, 0, B).
  const Chart c(k(1));
  const ChartEigenvalues e(c);
  const Vector3 v{c.A, Polynomial(), c.B};
  const Matrix3 t = symmetric(e.b1 - k(1) * e.b2, {}, e.b3 - k(1) * e.b2, {}, {}, {});
  Matrix3 projection;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) projection[i][j] = Polynomial(i == j ? 1 : 0) - v[i] * v[j];
  const Matrix3 projected = projection * t * projection;
  std::vector<Polynomial> differences;
  for (const auto& row : projected)
    for (const auto& entry : row) differences.push_back(c.reduced(entry));
  return differences;
}

}  // namespace

std::vector<Step> sphero_conal_steps() {
  return {
      identity(Place::quads, "sphero-conal-unit", "x^2 + y^2 + z^2 = 1", unit_vectors),
      identity(Place::quads, "sphero-conal-orthogonal", "the coordinate lines meet at right angles",
               orthogonal_lines),
      identity(Place::quads, "sphero-conal-metric",
               "E = (A^2 sin^2 theta + B^2 sin^2 eta) / (1 - A^2 cos^2 theta), G the same over "
               "1 - B^2 cos^2 eta",
               metric),
      identity(Place::quads, "sphero-conal-eigenvalues",
               "d+ = b2 + (b1-b2) sin^2 theta, d- = b2 - (b2-b3) sin^2 eta: d+ + d- = -v.T v, "
               "d+ d- = v.adj(T) v",
               plane_eigenvalues),
      identity(Place::quads, "sphero-conal-squares",
               "v_i^2 (b_i - b_j)(b_i - b_k) = (b_i - d+)(b_i - d-)", squares_of_coordinates),
      identity(Place::quads, "boundary-straight",
               "(1-s) d+ - (1+s) d- = p sin^2 theta + q sin^2 eta - c with p = (1-s)(b1-b2), "
               "q = (1+s)(b2-b3), c = 2 s b2",
               straight_boundary),
      identity(Place::theorem5, "singularities-tensor",
               "T-bar = b2 I - (b1-b3)/2 (s1 s2^T + s2 s1^T) with s1 = (A, 0, B), s2 = (-A, 0, B)",
               singular_decomposition),
      identity(Place::theorem5, "singularities-plane",
               "T-bar restricted to the plane across s1 is b2 I", singular_plane),
  };
}

}  // namespace proofs
