// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "hypotheses/needed.hpp"

#include "dominant_form.hpp"

namespace tensortopo::theory {
namespace {

Outcome violated_if(bool is_so, std::string witness) {
  return is_so ? Outcome::violated(std::move(witness)) : Outcome::holds();
}

Tensor diagonal(int a, int b, int c) { return {a, b, c, 0, 0, 0}; }

// The derivative of the determinant along u: the part of degree one of det(t + k u).
Rational derivative(const Tensor& t, const Tensor& u) {
  return (determinant(t + u) - determinant(t - u)) / Rational(2) - determinant(u);
}

}  // namespace

Outcome identity_as_a_tensor() {
  return violated_if(mode_squared(isotropic(Rational(1))) > 1,
                     "the identity, of trace 3: mode sqrt(2)");
}

Outcome equal_pair_with_trace() {
  const Tensor t = diagonal(1, 1, 0);
  return violated_if(mode_squared(t) == 0, text(t) +
                                               ", of trace 2: mode 0, and two equal "
                                               "eigenvalues");
}

Outcome parameter_beyond_one() {
  const auto mode_squared_at = [](int s) {
    const auto l = eigenvalues_of(Rational(s));
    return mode_squared(Tensor{l[0], l[1], l[2], 0, 0, 0});
  };
  return violated_if(mode_squared_at(1) == 1 && mode_squared_at(3) == 0,
                     "s = 3: eigenvalues 6, -6, 0, of mode 0, though s = 1 has mode 1");
}

Outcome discriminant_with_trace() {
  const Tensor t = diagonal(1, 0, 0);
  const Rational left = cubed(inner(t, t)) - Rational(54) * squared(determinant(t));
  return violated_if(left != 0,
                     text(t) + ", of trace 1: two equal eigenvalues, and |T|^6 - 54 det^2 = 1");
}

// The first has mode 0, so the Lode angle 30 degrees; the second's is more by a third of the arc
// sine of its mode's size. Three times the angle between them has the sine (3 - 4 q) sqrt(q), q the
// square of the sine of the angle, which is below 30 degrees.
Outcome lode_angles_with_trace() {
  const Tensor a = diagonal(1, 1, 0), b = diagonal(10, 10, -1);
  const Rational q = Rational(1) - squared(inner(a, b)) / (inner(a, a) * inner(b, b));
  const bool is_small = q * Rational(4) < 1 && mode_squared(b) < 1 && determinant(b) < 0;
  const Rational squared_sine = squared(Rational(3) - Rational(4) * q) * q;
  return violated_if(mode_squared(a) == 0 && is_small && squared_sine < mode_squared(b),
                     text(a) + " and " + text(b) +
                         ", with traces: thirds of the arc cosines of the modes are farther apart "
                         "than the tensors, whose angle has the squared sine " +
                         q.str());
}

Outcome zero_tensor() {
  const Tensor t{};
  return violated_if(determinant(t) == 0 && inner(t, t) == 0,
                     "T = 0 satisfies the equation for every mu, and has no mode");
}

Outcome line_of_one_tensor() {
  const Tensor t = diagonal(2, 1, -3);
  return violated_if(mode_squared(t) == mode_squared(Rational(2) * t),
                     "k " + text(t) + ", k > 0: the mode is constant, a polynomial of degree 0");
}

// Parameters of the mode on a path. The flat one is the nearer to both values of the other.
Outcome maxima_that_do_not_last() {
  const Rational high = fraction(1, 10), low = 0, flat = fraction(1, 20);
  return violated_if(low < flat && flat < high,
                     "parameters 1/10, 0, 1/10 and 1/20, 1/20, 1/20 along a path: less than the "
                     "persistence of the lesser maximum apart, and it has no counterpart");
}

// v is in the real domain of the first, and in the complex domain of the second.
Outcome two_orthogonal_tensors() {
  const Tensor first = diagonal(1, -1, 0), second = diagonal(12, 6, -18);
  const Vector3<Rational> v = {0, 0, 1};
  const Rational weight = boundary_weight(fraction(1, 2));
  return violated_if(
      boundary_form(first, v, weight) > 0 && boundary_form(second, v, weight) < 0,
      "the field of rank 3 orthogonal to " + text(first) + " and " + text(second) +
          ", s = 1/2: v = (0, 0, 1) is in the real domain of the first, and no tensor of the field "
          "has it, as it is in the complex domain of the second");
}

// N is isotropic across v, so each direction across v belongs to a tensor.
Outcome isotropic_across_vector() {
  const Tensor n = diagonal(34, 7, -41);
  const Vector3<Rational> v = {3, 0, 4};
  return violated_if(boundary_form(n, v, fraction(1, 4)) == 0,
                     "characteristic tensor along " + text(n) +
                         ", v along (3, 0, 4): g = 0, and the quotient is 0 / 0");
}

Outcome vanishing_boundary_tensor() {
  const Tensor n = diagonal(34, 7, -41);
  const Vector3<Rational> v = {fraction(3, 5), 0, fraction(4, 5)}, image = n * v;
  const Rational alpha = dot(v, image);
  // P N P = N - N v v^T - v v^T N + alpha v v^T.
  const Tensor across = isotropic(Rational(1)) - projection_to(v);
  const Tensor projected = n - Rational(2) * product_of(image, v) + alpha * projection_to(v);
  const Tensor t = projected + (alpha / Rational(2)) * across;
  return violated_if(inner(t, t) == 0, "characteristic tensor along " + text(n) +
                                           ", s = 0, v = (3/5, 0, 4/5) on the boundary: the tensor "
                                           "given is 0");
}

Outcome boundary_of_one_point() {
  const Tensor n = diagonal(1, 0, -1);
  const Vector3<Rational> v = {1, 0, 1};
  const Rational s = fraction(1, 2), upper = Rational(-2) * n.yy / (Rational(1) + s),
                 lower = Rational(-2) * n.yy / (Rational(1) - s);
  return violated_if(upper == lower && boundary_form(n, v, boundary_weight(s)) == 0,
                     "characteristic tensor along " + text(n) +
                         ", s = 1/2 below s0 = 1: the boundary has one point in an octant, along " +
                         text(v) + ", and meets no edge twice");
}

Outcome singularities_that_coincide() {
  const Tensor n = diagonal(1, 1, -2);
  const Rational a_squared = (n.xx - n.yy) / (n.xx - n.zz);
  return violated_if(a_squared == 0, "characteristic tensor along " + text(n) +
                                         ": A = 0, and the two pairs are one");
}

Outcome level_through_the_saddle() {
  const Tensor n = diagonal(5, 3, -8), saddle = diagonal(11, -13, 2);
  const bool is_critical = inner(n, saddle) == 0 && trace(saddle) == 0;
  return violated_if(is_critical && mode_squared(saddle) == Rational(1) - mode_squared(n),
                     "characteristic tensor along " + text(n) +
                         ", mu = mu0 = 143/343: the surface passes " + text(saddle) +
                         ", where all derivatives of the mode vanish, and is none there");
}

Outcome degenerate_saddle() {
  const Tensor n = diagonal(1, 0, -1), saddle = diagonal(1, -2, 1);
  return violated_if(inner(n, saddle) == 0 && mode_squared(saddle) == 1,
                     "characteristic tensor along " + text(n) + ": that tensor is " + text(saddle) +
                         ", degenerate, where the mode is least");
}

Outcome dual_of_degenerate_tensor() {
  const Tensor n = diagonal(1, 1, -2);
  const Rational size = inner(n, n);
  const Tensor t = square(n) - isotropic(Rational(size / Rational(3))) -
                   (Rational(3) * determinant(n) / size) * n;
  return violated_if(inner(t, t) == 0, "N = " + text(n) + ": T = 0, which has no mode");
}

Outcome third_equation_fails() {
  const Tensor first = diagonal(1, 1, -2), second = diagonal(1, -1, 0), third{0, 0, 0, 0, 1, 0};
  const Tensor t = first + second;  // u = v = 1, w = 0
  const Rational f = derivative(t, first), g = derivative(t, second), h = derivative(t, third);
  return violated_if(h == 0 && f != g,
                     "u " + text(first) + " + v " + text(second) + " + w " + text(third) +
                         " at (1, 1, 0): w = h = 0, so the two equations hold, and u g - v f = " +
                         Rational(g - f).str());
}

}  // namespace tensortopo::theory
