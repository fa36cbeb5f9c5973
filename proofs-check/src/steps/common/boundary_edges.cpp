// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "steps/common/boundary_edges.hpp"

#include "steps/common/ordered_eigenvalues.hpp"

namespace proofs {
namespace {

/// Of all coefficients of a polynomial in positive variables, or 0 if they differ.
int common_sign(const Polynomial& f) {
  int common = 0;
  for (const Rational& coefficient : f.coefficients()) {
    if (common != 0 && sgn(coefficient) != common) return 0;
    common = sgn(coefficient);
  }
  return common;
}

/// For s = p / q.
std::array<int, 3> crossings_at(Checks& c, const Polynomial& p, const Polynomial& q) {
  std::array<int, 3> found{};
  for (std::size_t i = 0; i < 3; ++i) found[i] = edge_crossings(c, i, roots_on_edge(i, p, q));
  return found;
}

}  // namespace

int edge_crossings(Checks& c, std::size_t i, const std::vector<Fraction>& roots) {
  const OrderedEigenvalues b;
  const Polynomial high = i == 0 ? b.b2 : b.b1, low = i == 2 ? b.b2 : b.b3;
  int number = 0;
  for (const auto& [numerator, denominator] : roots) {
    c.positive_on_orthant(denominator);
    const Polynomial above_low = numerator - low * denominator;
    const Polynomial below_high = high * denominator - numerator;
    if (common_sign(above_low) > 0 && common_sign(below_high) > 0) {
      ++number;
    } else {
      c.that(above_low.is_zero() || common_sign(above_low) < 0 || common_sign(below_high) < 0,
             "a crossing that signs do not place");
    }
  }
  return number;
}

std::vector<Fraction> roots_on_edge(std::size_t i, const Polynomial& p, const Polynomial& q) {
  const Polynomial numerator = Polynomial(-2) * OrderedEigenvalues().all()[i] * q;
  return {{numerator, q + p}, {numerator, q - p}};
}

std::array<int, 3> crossings_above_bifurcation(Checks& c) {
  // s between s0 = g / (2 b2 + g) and 1: (s0 + t) / (1 + t).
  const OrderedEigenvalues b;
  const auto t = variable("t"), g = variable("g");
  const Polynomial sum = b.b1 + b.b2;
  return crossings_at(c, g + t * sum, sum * (Polynomial(1) + t));
}

std::array<int, 3> crossings_below_bifurcation(Checks& c) {
  // s between 0 and s0: s0 / (1 + t).
  const OrderedEigenvalues b;
  return crossings_at(c, variable("g"), (b.b1 + b.b2) * (Polynomial(1) + variable("t")));
}

}  // namespace proofs
