// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The forms P and Q, the degree-six form, the discriminant and the derivative of the mode.
#include <array>

#include "certificates/step.hpp"
#include "steps/common/deviator.hpp"

namespace proofs {
namespace {

/// A symmetric tensor of any trace, and its deviator: by its definition, and in coordinates.
struct AnyTensor {
  Matrix3 deviator_matrix;
  Deviator deviator;

  explicit AnyTensor(Constants& k) {
    const auto xx = variable("xx"), yy = variable("yy"), zz = variable("zz"), xy = variable("xy"),
               yz = variable("yz"), xz = variable("xz");
    const Polynomial mean = k(1, 3) * (xx + yy + zz);
    deviator_matrix = symmetric(xx - mean, yy - mean, zz - mean, xy, yz, xz);
    deviator = {xx - yy, yy - zz, xy, yz, xz};
  }
};

std::vector<Polynomial> norm_is_three_squares(Constants& k) {
  const AnyTensor t(k);
  return {norm_form(t.deviator, k) - k(3) * inner(t.deviator_matrix, t.deviator_matrix)};
}

std::vector<Polynomial> determinant_is_27_determinants(Constants& k) {
  const AnyTensor t(k);
  return {determinant_form(t.deviator, k) - k(27) * determinant(t.deviator_matrix)};
}

std::vector<Polynomial> thrice_the_deviator(Constants& k) {
  const AnyTensor t(k);
  const auto& [a, b, xy, yz, xz] = t.deviator;
  const Matrix3 thrice =
      symmetric(k(2) * a + b, b - a, -(a + k(2) * b), k(3) * xy, k(3) * yz, k(3) * xz);
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      differences.push_back(thrice[i][j] - k(3) * t.deviator_matrix[i][j]);
  return differences;
}

std::vector<Polynomial> degree_six_form(Constants& k) {
  const Deviator t = Deviator::generic();
  const Polynomial mu2 = square(variable("mu"));
  const Polynomial norm2 = inner(tensor(t), tensor(t)), det = determinant(tensor(t));
  const Polynomial P = norm_form(t, k), Q = determinant_form(t, k);
  return {square(k(6) * Q) - k(18) * mu2 * cube(P) -
          k(486) * (k(54) * square(det) - mu2 * cube(norm2))};
}

std::vector<Polynomial> discriminant_of_eigenvalues(Constants& k) {
  // T = diag(l1, l2, l3) with l3 = -l1 - l2.
  const auto l1 = variable("l1"), l2 = variable("l2");
  const Polynomial l3 = -(l1 + l2);
  const Polynomial norm2 = l1 * l1 + l2 * l2 + l3 * l3, det = l1 * l2 * l3;
  const Polynomial discriminant = square((l1 - l2) * (l2 - l3) * (l1 - l3));
  return {cube(norm2) - k(54) * square(det) - k(2) * discriminant};
}

/// Determinant of the inner products of I, T, T^2 for a matrix T.
Polynomial gram_determinant(const Matrix3& t) {
  const Matrix3 t2 = t * t;
  const Polynomial s1 = trace(t), s2 = trace(t2), s3 = inner(t, t2), s4 = inner(t2, t2);
  return determinant(Matrix3{{{Polynomial(3), s1, s2}, {s1, s2, s3}, {s2, s3, s4}}});
}

std::vector<Polynomial> discriminant_is_gram(Constants& k) {
  const Deviator t = Deviator::generic();
  return {cube(norm_form(t, k)) - k(2) * square(determinant_form(t, k)) -
          k(54) * gram_determinant(tensor(t))};
}

std::vector<Polynomial> gram_of_eigenvalues(Constants& k) {
  const auto l1 = variable("l1"), l2 = variable("l2"), l3 = variable("l3");
  const Matrix3 t = symmetric(l1, l2, l3, {}, {}, {});
  return {k(1) * square((l1 - l2) * (l2 - l3) * (l1 - l3)) - gram_determinant(t)};
}

std::vector<Polynomial> discriminant_is_squares(Constants& k) {
  // Blind to multiples of I: take yy = 0, so xx = a, zz = -b.
  const Deviator d = Deviator::generic();
  const Matrix3 t = symmetric(d.a, {}, -d.b, d.xy, d.yz, d.xz);
  const Matrix3 u = t * t;
  const std::array<std::array<std::size_t, 2>, 3> pairs{{{0, 1}, {1, 2}, {0, 2}}};
  Polynomial sum;
  const auto diagonal_difference = [](const Matrix3& m, const std::array<std::size_t, 2>& pair) {
    return m[pair[0]][pair[0]] - m[pair[1]][pair[1]];
  };
  sum += k(1) * square(diagonal_difference(t, pairs[0]) * diagonal_difference(u, pairs[1]) -
                       diagonal_difference(t, pairs[1]) * diagonal_difference(u, pairs[0]));
  for (std::size_t n = 0; n < 3; ++n) {
    const auto& [i, j] = pairs[n];
    for (const auto& pair : pairs)
      sum += k(2) * square(diagonal_difference(t, pair) * u[i][j] -
                           diagonal_difference(u, pair) * t[i][j]);
    const auto& [i2, j2] = pairs[(n + 1) % 3];
    sum += k(12) * square(t[i][j] * u[i2][j2] - t[i2][j2] * u[i][j]);
  }
  return {sum - gram_determinant(tensor(d))};
}

std::vector<Polynomial> derivative_of_squared_mode(Constants& k) {
  // d is any derivation: it is known by dP and dQ.
  const auto P = variable("P"), Q = variable("Q"), dP = variable("dP"), dQ = variable("dQ");
  const auto d = [&](const Polynomial& f) {
    return f.derivative("P") * dP + f.derivative("Q") * dQ;
  };
  // d(Q^2 / P^3) = (d(Q^2) P^3 - Q^2 d(P^3)) / P^6, and the claim times P^6.
  return {d(square(Q)) * cube(P) - square(Q) * d(cube(P)) -
          Q * square(P) * (k(2) * P * dQ - k(3) * Q * dP)};
}

std::vector<Polynomial> derivative_of_mode(Constants& k) {
  // With N = sqrt(P), so P = N^2.
  const auto N = variable("N"), Q = variable("Q"), dN = variable("dN"), dQ = variable("dQ");
  const auto d = [&](const Polynomial& f) {
    return f.derivative("N") * dN + f.derivative("Q") * dQ;
  };
  const Polynomial P = square(N);
  // d(Q / N^3) = (dQ N^3 - Q d(N^3)) / N^6, and the claim times 2 N^7.
  return {k(2) * N * (dQ * cube(N) - Q * d(cube(N))) -
          square(N) * (k(2) * P * dQ - k(3) * Q * d(P))};
}

}  // namespace

std::vector<Step> form_steps() {
  return {
      identity(Place::forms, "norm-form",
               "P = 3 |dev T|^2, in a = xx - yy, b = yy - zz, xy, yz, xz", norm_is_three_squares),
      identity(Place::forms, "determinant-form", "Q = 27 det(dev T), in the same coordinates",
               determinant_is_27_determinants),
      identity(Place::forms, "thrice-deviator", "3 dev T has the diagonal 2a + b, b - a, -(a + 2b)",
               thrice_the_deviator),
      identity(Place::background, "degree-six-form",
               "(6Q)^2 - 18 mu^2 P^3 = 486 (54 det(T)^2 - mu^2 |T|^6)", degree_six_form),
      identity(Place::background, "discriminant-eigenvalues",
               "|T|^6 - 54 det(T)^2 = 2 (l1-l2)^2 (l2-l3)^2 (l1-l3)^2 for l1 + l2 + l3 = 0",
               discriminant_of_eigenvalues),
      identity(Place::forms, "gram-eigenvalues",
               "the Gram determinant of I, T, T^2 is (l1-l2)^2 (l2-l3)^2 (l1-l3)^2",
               gram_of_eigenvalues),
      identity(Place::forms, "discriminant-gram", "P^3 - 2 Q^2 = 54 Gram(I, T, T^2)",
               discriminant_is_gram),
      identity(Place::forms, "discriminant-squares",
               "Gram(I, T, T^2) is a sum of 13 squares of minors, weighted 1, 2 and 12",
               discriminant_is_squares),
      identity(Place::forms, "squared-mode-derivative", "d(Q^2 P^-3) = Q P^-4 (2 P dQ - 3 Q dP)",
               derivative_of_squared_mode),
      identity(Place::forms, "mode-derivative", "d(Q P^(-3/2)) = (2 P dQ - 3 Q dP) P^(-5/2) / 2",
               derivative_of_mode),
  };
}

}  // namespace proofs
