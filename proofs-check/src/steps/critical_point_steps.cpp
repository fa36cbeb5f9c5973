// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Critical points of the mode in space and on a plane, and the bifurcation. Eigenvalues b1, b2 and
// b3 = -b1 - b2; the mode squared is 54 det^2 / |.|^6, and equations are multiplied by
// denominators.
#include <array>

#include "certificates/step.hpp"

namespace proofs {
namespace {

using Eigenvalues = std::array<Polynomial, 3>;

Eigenvalues traceless() {
  const auto b1 = variable("b1"), b2 = variable("b2");
  return {b1, b2, -(b1 + b2)};
}

Polynomial inner(const Eigenvalues& u, const Eigenvalues& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
Polynomial sum(const Eigenvalues& u) { return u[0] + u[1] + u[2]; }
Polynomial determinant(const Eigenvalues& u) { return u[0] * u[1] * u[2]; }

/// mode(u)^2 + mode(v)^2 - 1, times |u|^6 |v|^6.
Polynomial modes_are_complementary(const Eigenvalues& u, const Eigenvalues& v, Constants& k) {
  const Polynomial u6 = cube(inner(u, u)), v6 = cube(inner(v, v));
  return k(54) * square(determinant(u)) * v6 + k(54) * square(determinant(v)) * u6 - k(1) * u6 * v6;
}

std::vector<Polynomial> saddle_in_space(Constants& k) {
  const Eigenvalues b = traceless();
  const Eigenvalues d{k(1) * b[1] - b[2], k(1) * b[2] - b[0], k(1) * b[0] - b[1]};
  return {sum(d), inner(d, b), inner(d, d) - k(3) * inner(b, b), modes_are_complementary(d, b, k)};
}

std::vector<Polynomial> critical_in_plane(Constants& k) {
  // T = N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N, times |N|^2.
  const Eigenvalues n = traceless();
  const Polynomial n2 = inner(n, n), n3 = cube(n[0]) + cube(n[1]) + cube(n[2]);
  Eigenvalues t;
  for (std::size_t i = 0; i < 3; ++i) t[i] = n2 * (square(n[i]) - k(1, 3) * n2) - k(1) * n3 * n[i];
  return {sum(t), inner(t, n), modes_are_complementary(t, n, k)};
}

std::vector<Polynomial> plane_and_space_agree(Constants& k) {
  // |N|^2 (N^2 - (|N|^2 / 3) I) - tr(N^3) N is a multiple of the differences of the eigenvalues.
  const Eigenvalues n = traceless();
  const Eigenvalues d{n[1] - n[2], n[2] - n[0], n[0] - n[1]};
  const Polynomial n2 = inner(n, n), n3 = cube(n[0]) + cube(n[1]) + cube(n[2]);
  const Polynomial factor = k(-1, 3) * determinant(d);
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i)
    differences.push_back(n2 * (square(n[i]) - k(1, 3) * n2) - k(1) * n3 * n[i] - factor * d[i]);
  return differences;
}

std::vector<Polynomial> bifurcation(Constants& k) {
  // s0 = (b1-b2) / (b1+b2).
  const Eigenvalues b = traceless();
  const Polynomial up = k(1) * b[0] - b[1], down = k(1) * b[0] + b[1];
  const Polynomial b6 = cube(inner(b, b));
  // c = p, times b1 + b2; then the mode of s0 squared against 1 - mode(T-bar)^2.
  return {k(2) * up * b[1] - (down - up) * (b[0] - b[1]),
          square(up) * square(k(9) * square(down) - square(up)) * b6 -
              cube(k(3) * square(down) + square(up)) * (b6 - k(54) * square(determinant(b)))};
}

std::vector<Polynomial> bifurcation_by_eigenvalue(Constants& k) {
  // |T-bar| = 1 makes b3^2 the only number: x = b3^2 = b3^2 / |b|^2, homogeneous of degree 6.
  const Eigenvalues b = traceless();
  const Polynomial x = square(b[2]), n = inner(b, b);
  return {k(54) * square(determinant(b)) - k(27, 2) * x * square(k(2) * x - n),
          k(2) * (cube(n) - k(54) * square(determinant(b))) -
              (k(2) * n - k(3) * x) * square(k(6) * x - n)};
}

}  // namespace

std::vector<Step> critical_point_steps() {
  return {
      identity(Place::saddle, "saddle-in-space",
               "D = (b2-b3, b3-b1, b1-b2): tr D = 0, <D, T-bar> = 0, |D|^2 = 3 |T-bar|^2, "
               "mode(D)^2 = 1 - mode(T-bar)^2",
               saddle_in_space),
      identity(Place::theorem6, "critical-in-plane",
               "T = N^2 - (|N|^2/3) I - (tr N^3 / |N|^2) N: tr T = 0, <T, N> = 0, "
               "mode(T)^2 = 1 - mode(N)^2",
               critical_in_plane),
      identity(Place::saddle, "critical-plane-space",
               "that T is (n1-n2)(n2-n3)(n1-n3) / (3 |N|^2) times (n2-n3, n3-n1, n1-n2)",
               plane_and_space_agree),
      identity(Place::theorem5, "bifurcation",
               "s0 = (b1-b2) / (b1+b2): c = p there, and mode(s0)^2 = 1 - mode(T-bar)^2",
               bifurcation),
      identity(Place::theorem5, "bifurcation-eigenvalue",
               "x = b3^2, |T-bar| = 1: mode(T-bar)^2 = 27 x (2x-1)^2 / 2 and its complement is "
               "(2-3x) (6x-1)^2 / 2",
               bifurcation_by_eigenvalue),
  };
}

}  // namespace proofs
