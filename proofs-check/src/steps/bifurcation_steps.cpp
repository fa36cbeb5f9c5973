// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The triangle of the squares m_x + m_y + m_z = 1: corners, edges, and where the boundary crosses
// them. The norm of T-bar is left free: what the paper makes 1/2 is n = |T-bar|^2 / 2.
#include <array>

#include "certificates/step.hpp"
#include "steps/common/boundary_edges.hpp"
#include "steps/common/ordered_eigenvalues.hpp"

namespace proofs {
namespace {

std::vector<Polynomial> half_norm(Constants& k) {
  const OrderedEigenvalues b;
  return {k(1, 2) * dot(b.all(), b.all()) -
          (k(1) * square(b.b1) + k(1) * b.b1 * b.b2 + k(1) * square(b.b2))};
}

void first_two_eigenvalues(Checks& c) {
  const OrderedEigenvalues b;
  const Polynomial rest = b.half_norm() - square(b.b1) - square(b.b2);
  c.equal(rest, c.k(1) * b.b1 * b.b2);
  c.positive_on_orthant(rest);
  c.vanishes(rest.with("b2", 0));
}

void first_two_without_medium(Checks& c) {
  const Polynomial b1 = c.k(1), b3 = c.k(-1);
  c.vanishes(b1 + b3);
  c.equal(rational(1, 2) * (square(b1) + square(b3)), square(b1));
}

void first_and_third_eigenvalue(Checks& c) {
  const OrderedEigenvalues b;
  const Polynomial below = b.half_norm() - square(b.b1), above = square(b.b3) - b.half_norm();
  c.equal(below, c.k(1) * b.b2 * (b.b1 + b.b2));
  c.equal(above, c.k(1) * b.b1 * b.b2);
  c.positive_on_orthant(below);
  c.positive_on_orthant(above);
}

void first_and_third_without_medium(Checks& c) {
  // diag(1, 0, -1): both squares are half the squared norm.
  const Vector3 b{c.k(1), 0, c.k(-1)};
  const Polynomial half = rational(1, 2) * dot(b, b);
  c.equal(square(b[0]), half);
  c.equal(square(b[2]), half);
}

void second_eigenvalue(Checks& c) {
  const OrderedEigenvalues b;
  const Polynomial below = b.half_norm() - square(b.b2);
  c.equal(below, c.k(1) * b.b1 * (b.b1 + b.b2));
  // Also with b2 = 0.
  c.positive_on_orthant(below);
  c.positive_on_orthant(below.with("b2", 0));
}

std::vector<Polynomial> function_at_mode_one(Constants& k) {
  const OrderedEigenvalues b;
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i) {
    Vector3 corner;
    corner[i] = k(1);
    differences.push_back(boundary_function(b.all(), corner, 0) -
                          (b.half_norm() - k(1) * square(b.all()[i])));
  }
  return differences;
}

void signs_at_corners(Checks& c) {
  const OrderedEigenvalues b;
  const auto at = [&](std::size_t i) {
    Vector3 corner;
    corner[i] = 1;
    return boundary_function(b.all(), corner, 0);
  };
  c.equal(at(0), c.k(1) * b.b2 * (b.b1 + b.b2));
  c.equal(at(1), c.k(1) * b.b1 * (b.b1 + b.b2));
  c.equal(at(2), c.k(-1) * b.b1 * b.b2);
  c.positive_on_orthant(at(0));
  c.positive_on_orthant(at(1));
  c.negative_on_orthant(at(2));
}

void signs_without_medium(Checks& c) {
  const Vector3 b{c.k(1), 0, c.k(-1)};
  c.vanishes(boundary_function(b, {1, 0, 0}, 0));
  c.vanishes(boundary_function(b, {0, 0, 1}, 0));
}

/// The edge on which m_i = 0: there the boundary function is the numerator of m_i in alpha.
std::vector<Polynomial> function_on_edges(Constants& k) {
  const OrderedEigenvalues b;
  const auto x = variable("x"), cosine2 = square(variable("c"));
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t first = (i + 1) % 3, second = (i + 2) % 3;
    Vector3 m;
    m[first] = x;
    m[second] = k(1) - x;
    const Polynomial alpha = b.all()[first] * m[first] + b.all()[second] * m[second];
    differences.push_back(boundary_function(b.all(), m, cosine2) -
                          k(1) * square_numerator(b.all()[i], alpha, cosine2));
  }
  return differences;
}

void edges_at_mode_one(Checks& c) {
  const OrderedEigenvalues b;
  const std::array<Polynomial, 3> expected{c.k(1), c.k(1), c.k(0)};
  for (std::size_t i = 0; i < 3; ++i)
    c.equal(edge_crossings(c, i, {{-b.all()[i], 1}}), expected[i]);
}

void edge_without_medium(Checks& c) {
  // diag(1, 0, -1): the boundary function vanishes on the whole edge m_y = 0.
  const auto x = variable("x");
  c.vanishes(boundary_function({c.k(1), 0, c.k(-1)}, {x, 0, c.k(1) - x}, 0));
}

void edges_before(Checks& c) {
  const std::array<int, 3> found = crossings_above_bifurcation(c);
  const std::array<Polynomial, 3> expected{c.k(1), c.k(1), c.k(0)};
  for (std::size_t i = 0; i < 3; ++i) c.equal(found[i], expected[i]);
}

void edges_after(Checks& c) {
  const std::array<int, 3> found = crossings_below_bifurcation(c);
  const std::array<Polynomial, 3> expected{c.k(0), c.k(2), c.k(0)};
  for (std::size_t i = 0; i < 3; ++i) c.equal(found[i], expected[i]);
}

void edges_at_bifurcation(Checks& c) {
  const OrderedEigenvalues b;
  const Polynomial p = variable("g"), q = b.b1 + b.b2;
  const std::array<Polynomial, 3> expected{c.k(0), c.k(1), c.k(0)};
  for (std::size_t i = 0; i < 3; ++i)
    c.equal(edge_crossings(c, i, roots_on_edge(i, p, q)), expected[i]);
  c.vanishes(square(q) * boundary_function(b.all(), {0, 0, 1}, 0) +
             c.k(1, 4) * (square(q) - square(p)) * square(b.b3));
}

std::vector<Polynomial> corner_at_bifurcation(Constants& k) {
  // 4 Delta at the corner, which is (b1+b2)^2 (s0^2 - s^2) with s0 = (b1-b2)/(b1+b2).
  const OrderedEigenvalues b;
  const auto s = variable("s");
  const Polynomial f = boundary_function(b.all(), {0, 0, k(1)}, k(1) - s * s);
  return {k(4) * f - (square(b.b1 - b.b2) - square(s * (b.b1 + b.b2)))};
}

void other_corners(Checks& c) {
  const OrderedEigenvalues b;
  const auto cosine = variable("c");
  const Polynomial first = boundary_function(b.all(), {c.k(1), 0, 0}, square(cosine));
  const Polynomial second = boundary_function(b.all(), {0, c.k(1), 0}, square(cosine));
  c.equal(first, b.b2 * (b.b1 + b.b2) + c.k(1, 4) * square(b.b1 * cosine));
  c.equal(second, b.b1 * (b.b1 + b.b2) + c.k(1, 4) * square(b.b2 * cosine));
  c.positive_on_orthant(first);
  c.positive_on_orthant(second);
}

std::vector<Polynomial> bifurcation_moebius(Constants& k) {
  // sbar = 3 b2 / (b1 - b3) belongs to -T-bar, whose medium eigenvalue is -b2; times b1 - b3.
  const OrderedEigenvalues b;
  const Polynomial gap = b.b1 - b.b3, bar = k(3) * b.b2;
  const auto x = variable("x");
  const Polynomial image = k(3) * (k(1) - x), scale = k(3) + x;
  return {k(3) * (gap - bar) * (b.b1 + b.b2) - (k(3) * gap + bar) * (b.b1 - b.b2),
          // The map is its own inverse.
          k(3) * (scale - image) - x * (k(3) * scale + image)};
}

std::vector<Polynomial> limit_at_mode_zero(Constants& k) {
  // s = 0 and alpha = -2 b2, both ends of the range; denominators (b_i - b_j)(b_i - b_k).
  const OrderedEigenvalues b;
  const Polynomial alpha = k(-2) * b.b2;
  const auto numerator = [&](const Polynomial& bi) { return square_numerator(bi, alpha, 1); };
  return {(b.b1 - b.b3) * numerator(b.b1) - k(1) * (b.b1 - b.b2) * (b.b1 - b.b2) * (b.b1 - b.b3),
          numerator(b.b2),
          (b.b1 - b.b3) * numerator(b.b3) - k(1) * (b.b2 - b.b3) * (b.b1 - b.b3) * (b.b2 - b.b3)};
}

}  // namespace

std::vector<Step> bifurcation_steps() {
  const Place place = Place::theorem5;
  const std::string no_medium = "T-bar ~ diag(1, 0, -1): ";
  return {
      identity(place, "half-norm", "b1 + b2 + b3 = 0: b1^2 + b1 b2 + b2^2 = |T-bar|^2 / 2",
               half_norm),
      correction(
          place, "first-two-eigenvalues", Kind::inequality,
          {"b1^2 + b2^2 < 1/2", "<= 1/2, with equality only for b2 = 0: the difference is b1 b2",
           no_medium + "b1^2 + b2^2 = 1/2 of the squared norm"},
          first_two_eigenvalues, first_two_without_medium),
      correction(place, "first-and-third-eigenvalue", Kind::inequality,
                 {"b1^2 < 1/2 < b3^2",
                  "<=, with equality only for b2 = 0: the differences are b2 (b1+b2) and b1 b2",
                  no_medium + "b1^2 = b3^2 = 1/2 of the squared norm"},
                 first_and_third_eigenvalue, first_and_third_without_medium),
      claim(place, "second-eigenvalue", Kind::inequality,
            "b2^2 < 1/2: the difference is b1 (b1+b2), which is positive even for b2 = 0",
            second_eigenvalue),
      identity(place, "corners-at-mode-one",
               "mu = 1: the boundary function is linear, and |T-bar|^2/2 - b_i^2 at the corners",
               function_at_mode_one),
      correction(place, "corner-signs", Kind::inequality,
                 {"mu = 1: the boundary function is negative at (0, 0, 1) and positive at "
                  "(1, 0, 0) and (0, 1, 0)",
                  "if b2 > 0: it is -b1 b2, b2 (b1+b2) and b1 (b1+b2) there",
                  no_medium + "it is 0 at (0, 0, 1) and at (1, 0, 0)"},
                 signs_at_corners, signs_without_medium),
      identity(place, "function-on-edges",
               "where m_i = 0 the boundary function is the numerator of m_i as a function of alpha",
               function_on_edges),
      correction(place, "edges-at-mode-one", Kind::count,
                 {"mu = 1: the boundary meets each of the edges m_x = 0 and m_y = 0 exactly once",
                  "if b2 > 0: once each, and the edge m_z = 0 not at all",
                  no_medium + "the boundary holds the whole edge m_y = 0"},
                 edges_at_mode_one, edge_without_medium),
      claim(place, "edges-before-bifurcation", Kind::count,
            "s0 < s < 1, s0 = (b1-b2)/(b1+b2): the boundary meets the edges m_x = 0, m_y = 0, "
            "m_z = 0 in 1, 1, 0 points",
            edges_before),
      claim(place, "edges-after-bifurcation", Kind::count,
            "0 < s < s0: the boundary meets the same edges in 0, 2, 0 points", edges_after),
      claim(place, "edges-at-bifurcation", Kind::count,
            "s = s0: the boundary passes through (0, 0, 1) and meets the edges in 0, 1, 0 further "
            "points",
            edges_at_bifurcation),
      identity(place, "corner-at-bifurcation",
               "4 Delta at (0, 0, 1) is (b1+b2)^2 (s0^2 - s^2): zero at s0 only",
               corner_at_bifurcation),
      claim(place, "other-corners", Kind::inequality,
            "b2 > 0: Delta at (1, 0, 0) and (0, 1, 0) is positive for every mode", other_corners),
      identity(place, "bifurcation-moebius",
               "sbar = 3 b2/(b1-b3), the s of |mode T-bar|: s0 = 3 (1 - sbar) / (3 + sbar), a map "
               "that is its own inverse",
               bifurcation_moebius),
      identity(place, "limit-at-mode-zero",
               "s = 0, alpha = -2 b2: m_x = (b1-b2)/(b1-b3), m_y = 0, m_z = (b2-b3)/(b1-b3), the "
               "singularities",
               limit_at_mode_zero),
  };
}

}  // namespace proofs
