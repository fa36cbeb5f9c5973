// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The mode as a rational function of s = sin(theta), and as the cosine of the Lode angle.
#include <array>

#include "certificates/step.hpp"

namespace proofs {
namespace {

std::vector<Polynomial> eigenvalues_of_s(Constants& k) {
  const auto s = variable("s");
  const Polynomial l1 = k(3) + s, l2 = k(-2) * s, l3 = s - k(3);
  return {l1 + l2 + l3, l1 * l1 + l2 * l2 + l3 * l3 - k(6) * (k(3) + s * s),
          l1 * l2 * l3 - k(2) * s * (k(9) - s * s)};
}

std::vector<Polynomial> mode_of_s(Constants& k) {
  // mode^2 = 54 det^2 / |.|^6, times the denominators.
  const auto s = variable("s");
  const Polynomial l1 = Polynomial(3) + s, l2 = Polynomial(-2) * s, l3 = s - Polynomial(3);
  const Polynomial norm2 = l1 * l1 + l2 * l2 + l3 * l3, det = l1 * l2 * l3;
  return {k(54) * square(det) * cube(k(3) + s * s) -
          square(s) * square(k(9) - s * s) * cube(norm2)};
}

std::vector<Polynomial> s_of_eigenvalues(Constants& k) {
  // At s = 3 |l2| / (l1 - l3), times l1 - l3: the vector (3+s, -2s, s-3) is a multiple of (l1, l2,
  // l3) with l2 <= 0 and sum zero.
  const auto l1 = variable("l1"), l3 = variable("l3");
  const Polynomial l2 = -(l1 + l3), gap = l1 - l3, s = k(-3) * l2;
  return {k(3) * gap + s - k(6) * l1, k(-2) * s - k(6) * l2, s - k(3) * gap - k(6) * l3};
}

std::vector<Polynomial> triple_angle(Constants& k) {
  // s = sqrt(3) tan(f) with f = arcsin(mu) / 3: sin f = s / n, n^2 = 3 + s^2; times n^3.
  const auto s = variable("s"), n = variable("n");
  const Polynomial claim = s * (k(9) - s * s);
  return {(k(3) * s * square(n) - k(4) * cube(s) - claim).with_square("n", k(3) + s * s)};
}

std::vector<Polynomial> mode_increases_with_s(Constants& k) {
  // f = s (9 - s^2) / n^3, n dn = s ds: the claim times n^5.
  const auto s = variable("s"), n = variable("n");
  const Polynomial numerator = s * (k(9) - s * s);
  const Polynomial derivative = numerator.derivative("s") * square(n) - k(3) * numerator * s;
  return {(derivative - k(27) * (k(1) - s * s)).with_square("n", k(3) + s * s)};
}

std::vector<Polynomial> complement_of_mode(Constants& k) {
  const auto s2 = square(variable("s"));
  return {cube(k(3) + s2) - s2 * square(k(9) - s2) - k(27) * square(k(1) - s2)};
}

std::vector<Polynomial> rational_modes(Constants& k) {
  // s = (3 - t^2) / (2t) makes 3 + s^2 a square; times 4 t^2.
  const auto t2 = square(variable("t"));
  return {k(12) * t2 + square(k(3) - t2) - square(k(3) + t2)};
}

std::vector<Polynomial> rational_pairs(Constants& k) {
  struct Pair {
    long s_numerator, s_denominator, mu_numerator, mu_denominator;
  };
  constexpr std::array<Pair, 5> pairs{{{1, 4, 143, 343},
                                       {11, 24, 55693, 79507},
                                       {23, 40, 319033, 389017},
                                       {11, 80, 632269, 2685619},
                                       {1, 15, 253, 2197}}};
  std::vector<Polynomial> differences;
  for (const auto& pair : pairs) {
    const Polynomial s2 = square(k(pair.s_numerator, pair.s_denominator));
    const Polynomial mu = k(pair.mu_numerator, pair.mu_denominator);
    differences.push_back(square(mu) * cube(Polynomial(3) + s2) - s2 * square(Polynomial(9) - s2));
  }
  return differences;
}

std::vector<Polynomial> lode_angle(Constants& k) {
  // Eigenvalues 2 cos f, 2 cos(f -+ 2 pi / 3) in c = cos f, z = sin f, w = sqrt(3).
  const auto c = variable("c"), z = variable("z"), w = variable("w");
  const Polynomial l1 = k(2) * c, l2 = w * z - c, l3 = k(-1) * w * z - c;
  const auto reduced = [&](const Polynomial& f) {
    return f.with_square("w", k(3)).with_square("z", Polynomial(1) - square(c));
  };
  const Polynomial cos_3f = k(4) * cube(c) - k(3) * c;
  // Norm sqrt(6), so the mode 3 sqrt(6) det / |.|^3 is det / 2.
  return {l1 + l2 + l3, reduced(l1 * l1 + l2 * l2 + l3 * l3 - k(6)),
          reduced(l1 * l2 * l3 - k(2) * cos_3f)};
}

}  // namespace

std::vector<Step> mode_parameter_steps() {
  return {
      identity(Place::background, "mode-parameter-eigenvalues",
               "(3+s, -2s, s-3) has sum 0, squared norm 6 (3+s^2), product 2 s (9-s^2)",
               eigenvalues_of_s),
      identity(Place::background, "mode-parameter",
               "its mode^2 = 54 det^2 / |.|^6 = s^2 (9-s^2)^2 / (3+s^2)^3", mode_of_s),
      identity(Place::background, "mode-parameter-inverse",
               "l1 + l2 + l3 = 0, s = -3 l2 / (l1-l3): (3+s, -2s, s-3) = 6 (l1, l2, l3) / (l1-l3)",
               s_of_eigenvalues),
      identity(Place::corollary3, "mode-parameter-angle",
               "sin f = s / sqrt(3+s^2): 3 sin f - 4 sin^3 f = s (9-s^2) / (3+s^2)^(3/2)",
               triple_angle),
      identity(Place::corollary3, "mode-parameter-derivative",
               "d/ds [s (9-s^2) / (3+s^2)^(3/2)] = 27 (1-s^2) / (3+s^2)^(5/2)",
               mode_increases_with_s),
      identity(Place::background, "mode-parameter-complement",
               "1 - mu^2 = 27 (1-s^2)^2 / (3+s^2)^3", complement_of_mode),
      identity(Place::forms, "mode-parameter-rational",
               "s = (3-t^2) / (2t): 3 + s^2 = ((3+t^2) / (2t))^2", rational_modes),
      identity(Place::forms, "mode-parameter-pairs",
               "s = 1/4, 11/24, 23/40, 11/80, 1/15 have mu = 143/343, 55693/79507, 319033/389017, "
               "632269/2685619, 253/2197",
               rational_pairs),
      identity(
          Place::screen, "lode-angle",
          "2 (cos f, cos(f - 2 pi/3), cos(f + 2 pi/3)) has sum 0, norm sqrt(6) and mode cos 3f",
          lode_angle),
  };
}

}  // namespace proofs
