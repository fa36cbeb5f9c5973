// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Loops of the complex domain's boundary in space. With T-bar diagonal, changes of signs of v's
// coordinates map the boundary to itself, and its tensors with it; averages of the weight of T0
// over such tensors show which loops can avoid the plane at infinity.
#include "certificates/step.hpp"
#include "steps/common/ordered_eigenvalues.hpp"

namespace proofs {
namespace {

/// P T-bar P + (alpha/2)(1 + s^2/3) P - (s^2/3) alpha v v^T for v = (a, b, c): the tensor on the
/// boundary, up to a factor.
Matrix3 tensor_on_boundary(Constants& k, const Vector3& eigenvalues, const Polynomial& alpha) {
  const auto s = variable("s");
  const Vector3 v{variable("a"), variable("b"), variable("c")};
  Matrix3 t;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Polynomial both = v[i] * v[j];
      const Polynomial projection = (i == j ? Polynomial(1) : Polynomial()) - both;
      const Polynomial across = (i == j ? eigenvalues[i] : Polynomial()) -
                                (eigenvalues[i] + eigenvalues[j]) * both + alpha * both;
      t[i][j] = across + k(1, 2) * alpha * (k(1) + k(1, 3) * square(s)) * projection -
                k(1, 3) * square(s) * alpha * both;
    }
  return t;
}

std::vector<Polynomial> entries_of_tensor(Constants& k) {
  // alpha stands for v.T-bar v; the unit length of v is not used.
  const OrderedEigenvalues b;
  const auto alpha = variable("alpha"), s = variable("s");
  Constants unchanged;
  const Matrix3 t = tensor_on_boundary(unchanged, b.all(), alpha);
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, m = (i + 2) % 3;
    const Vector3 v{variable("a"), variable("b"), variable("c")};
    // The eigenvalue of the third axis, as the three have sum 0.
    differences.push_back(t[i][j] -
                          v[i] * v[j] * (b.all()[m] + k(1, 2) * (k(1) - square(s)) * alpha));
    // Where the coordinate is 0.
    const std::string name = i == 0 ? "a" : i == 1 ? "b" : "c";
    differences.push_back(t[i][i].with(name, 0) -
                          (b.all()[i] + k(1, 2) * alpha * (k(1) + k(1, 3) * square(s))));
  }
  return differences;
}

std::vector<Polynomial> averages(Constants& k) {
  // Over b -> -b: xy and yz cancel. Over a -> -a as well: xz cancels, and a diagonal tensor is
  // left.
  const OrderedEigenvalues b;
  const Vector3 v{variable("a"), variable("b"), variable("c")};
  const Polynomial alpha = b.b1 * square(v[0]) + b.b2 * square(v[1]) + b.b3 * square(v[2]);
  Constants unchanged;
  const Matrix3 t = tensor_on_boundary(unchanged, b.all(), alpha);
  const auto turned = [](const Polynomial& f, const std::string& name) {
    return f.with(name, -variable(name));
  };
  const Polynomial minus = k(-1);
  return {turned(t[0][1], "b") - minus * t[0][1], turned(t[1][2], "b") - minus * t[1][2],
          turned(t[0][2], "a") - minus * t[0][2], turned(t[0][2], "b") - k(1) * t[0][2],
          turned(t[0][0], "a") - t[0][0],         turned(t[1][1], "b") - t[1][1],
          turned(t[2][2], "a") - t[2][2]};
}

std::vector<Polynomial> averaged_weights(Constants& k) {
  // A functional n on tau D + xi xz, and on tau D - xi xz for the other loop.
  const auto tau = variable("tau"), xi = variable("xi"), along = variable("nD"),
             product = variable("nxz");
  const Polynomial first = tau * along + xi * product, second = tau * along - xi * product;
  return {first + second - k(2) * tau * along, first - second - k(2) * xi * product};
}

/// t_ii times 3 (1 + sign s) at alpha = -2 b_i / (1 + sign s), where m_i = 0.
Polynomial diagonal_at_end(Constants& k, const Polynomial& eigenvalue, int sign) {
  const auto s = variable("s");
  const Polynomial scale = Polynomial(1) + Polynomial(sign) * s;
  return k(3) * eigenvalue * scale - eigenvalue * (k(3) + square(s));
}

Polynomial with_parameter(const Polynomial& f) {
  // s = p / (p + q), times (p + q)^2.
  const auto p = variable("p"), q = variable("q");
  const std::vector<Polynomial> powers = f.coefficients_of("s");
  Polynomial sum;
  for (std::size_t i = 0; i < powers.size(); ++i) {
    Polynomial term = powers[i];
    for (std::size_t j = 0; j < i; ++j) term = term * p;
    for (std::size_t j = i; j < 2; ++j) term = term * (p + q);
    sum += term;
  }
  return sum;
}

void diagonal_changes_sign(Checks& c) {
  // D = (b2-b3, b3-b1, b1-b2): D_yy < 0 < D_xx.
  const OrderedEigenvalues b;
  c.positive_on_orthant(b.b2 - b.b3);
  c.negative_on_orthant(b.b3 - b.b1);
  const auto s = variable("s");
  // Both ends of the range of alpha for s < s0, on m_y = 0: t_yy > 0 and t_yy < 0.
  const Polynomial upper = diagonal_at_end(c.k, b.b2, 1), lower = diagonal_at_end(c.k, b.b2, -1);
  c.equal(upper, b.b2 * s * (c.k(3) - s));
  c.equal(lower, c.k(-1) * b.b2 * s * (c.k(3) + s));
  c.positive_on_orthant(with_parameter(upper));
  c.negative_on_orthant(with_parameter(lower));
  // For s > s0 the lower end is on m_x = 0: t_xx > 0, so tau > 0 there and tau < 0 at the upper
  // end.
  const Polynomial other = diagonal_at_end(c.k, b.b1, 1);
  c.equal(other, b.b1 * s * (c.k(3) - s));
  c.positive_on_orthant(with_parameter(other));
}

void product_changes_sign(Checks& c) {
  // t_xz / (a c) = b2 + (1 - s^2) alpha / 2, at alpha = -2 b2 / (1 + s) and at -2 b2 / (1 - s).
  const OrderedEigenvalues b;
  const auto s = variable("s");
  const Polynomial one = 1;
  const auto at = [&](int sign) {
    const Polynomial scale = one + Polynomial(sign) * s;
    return exact_quotient(b.b2 * scale - (one - square(s)) * b.b2, scale);
  };
  c.equal(at(1), c.k(1) * s * b.b2);
  c.equal(at(-1), c.k(-1) * s * b.b2);
  c.positive_on_orthant(at(1));
  c.negative_on_orthant(at(-1));
}

}  // namespace

std::vector<Step> loop_steps() {
  const Place place = Place::loops;
  return {
      identity(place, "boundary-tensor-entries",
               "the tensor on the boundary at v = (a, b, c) has the entries t_ij = v_i v_j (b_k + "
               "cos^2(theta) alpha / 2), and t_ii = b_i + (alpha/2)(1 + s^2/3) where v_i = 0",
               entries_of_tensor),
      identity(place, "boundary-tensor-average",
               "b -> -b changes the signs of xy and yz alone, a -> -a that of xz: the mean over "
               "the first is tau D + xi xz, and over a -> -a that of the other loop, tau D - xi xz",
               averages),
      identity(place, "weights-of-loops",
               "a linear weight has the means n(D) tau + n(xz) xi on a loop and n(D) tau - n(xz) "
               "xi on the other, of sum 2 n(D) tau and difference 2 n(xz) xi",
               averaged_weights),
      claim(place, "loop-diagonal-sign", Kind::inequality,
            "tau changes its sign along each loop: it is negative at the upper end of alpha and "
            "positive at the lower end",
            diagonal_changes_sign),
      claim(place, "loop-product-sign", Kind::inequality,
            "s < s0: xi changes its sign along each loop. So no weight has one sign on both loops, "
            "nor a sign on each: at most one loop avoids the plane at infinity, and for s > s0 the "
            "one loop never does",
            product_changes_sign),
  };
}

}  // namespace proofs
