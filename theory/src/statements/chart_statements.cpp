// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What depends on the eigenvalues of the characteristic tensor.
#include <algorithm>

#include "dominant_form.hpp"
#include "frames.hpp"
#include "groups.hpp"

namespace tensortopo::theory {
namespace {

// Points of an open edge where the boundary function, quadratic along it, is zero.
int zeros_on_edge(const Values& l, const Rational& s, const Squares& from, const Squares& to) {
  Squares middle;
  for (std::size_t i = 0; i < 3; ++i) middle[i] = (from[i] + to[i]) / Rational(2);
  const Rational weight = boundary_weight(s);
  const Rational f = boundary_at(l, from, weight), g = boundary_at(l, middle, weight),
                 h = boundary_at(l, to, weight);
  const Rational a = Rational(2) * (f + h) - Rational(4) * g, b = h - f - a;
  if (f * h < 0) return 1;
  const Rational discriminant = b * b - Rational(4) * a * f;
  const bool inside = a != 0 && -b / (a + a) > 0 && -b / (a + a) < 1;
  if (!inside || discriminant < 0) return 0;
  return discriminant == 0 ? 1 : 2;
}

const auto singularities = [](const Trial& trial, auto& facts) {
  const auto values = characteristic_values(trial);
  if (!values) return facts.not_applicable(kNoFrame);
  const Values& l = *values;
  const Rational width = l[0] - l[2];
  const Squares exact = {Rational((l[0] - l[1]) / width), Rational(0),
                         Rational((l[1] - l[2]) / width)};
  const auto quarter = facts.claimed(1, 4);
  const auto value_at = [&](const Squares& m) {
    return boundary_at(triple_in(facts, l), triple_in(facts, m), quarter);
  };
  facts.about([&] { return frame_place(l, Rational(0)); });
  facts.zero("boundary function of mode 0 at the singularity", value_at(exact));
  // A quarter of the squared gap of the projected tensor's eigenvalues: positive anywhere else.
  Random random = trial.random;
  Squares other = {random.part(), random.part(), random.part()};
  const Rational sum = other[0] + other[1] + other[2];
  facts.configuration(shape_of(l, {other[0], other[1], other[2]}));
  if (sum == 0) return;
  for (Rational& x : other) x = x / sum;
  if (other == exact) return;
  facts.about([&] { return frame_place(l, Rational(0)) + ", squares " + triple_text(other); });
  facts.positive("boundary function of mode 0 elsewhere", value_at(other));
};

// Halving the part of the edge between a singularity and the major eigenvector, until a point is in
// the complex domain of the larger parameter only.
bool found_between(const Values& l, const Rational& smaller, const Rational& larger) {
  Rational low = (l[1] - l[2]) / Rational(l[0] - l[2]), high(0), third = low;
  for (int step = 0; step < 200; ++step) {
    const Squares m = {Rational(Rational(1) - third), Rational(0), third};
    if (boundary_at(l, m, boundary_weight(larger)) >= 0) {
      high = third;
    } else if (boundary_at(l, m, boundary_weight(smaller)) < 0) {
      low = third;
    } else {
      return true;
    }
    third = (low + high) / Rational(2);
  }
  return false;
}

void nesting(const Trial& trial, Facts<Rational>& facts) {
  const auto values = characteristic_values(trial);
  if (!values) return facts.not_applicable(kNoFrame);
  Random random = trial.random;
  const auto drawn = std::minmax({random.part(), random.part()});
  const Rational &smaller = drawn.first, &larger = drawn.second;
  if (smaller == larger) return facts.not_applicable("equal modes were drawn");
  facts.configuration(shape_of(*values, {smaller, larger}));
  const Tensor n = tensor_of(*values, trial.frame->eigenvectors);
  const bool neutral = (*values)[1] == 0;
  // cos^2(theta), which the weight is a quarter of, falls from 1 to 0.
  const Rational one = facts.claimed(1), sum = boundary_weight(smaller) + boundary_weight(larger);
  facts.equal("weights and squares of s", facts.claimed(4) * sum,
              one + one - squared(smaller) - squared(larger));
  for (int i = 0; i < 4; ++i) {
    const Vector3<Rational> v = random_basis(random)[2];
    const bool in_smaller = boundary_form(n, v, boundary_weight(smaller)) < 0;
    const bool in_larger = boundary_form(n, v, boundary_weight(larger)) < 0;
    facts.about([&] {
      return frame_place(*values, smaller) + " and " + larger.str() + ", v = " + text(v);
    });
    facts.holds("subset", in_larger || !in_smaller);
    if (neutral) facts.holds("empty at determinant 0", !in_larger);
  }
  if (!neutral && !found_between(*values, smaller, larger)) {
    facts.undecided("no vector found between " + frame_place(*values, smaller) + " and " +
                    larger.str());
  }
}

// For diag(1, 0, -1) the boundary function is y^2 |v|^2 + (1 - s^2) (x^2 - z^2)^2 / 4: nowhere
// negative. Forms of degree four that agree on the lattice of order four are equal.
Outcome empty_complex_domains() {
  const Tensor n = {1, 0, -1, 0, 0, 0};
  for (const Rational& s : {fraction(1, 3), fraction(1, 2)}) {
    const Rational weight = boundary_weight(s);
    for (int i = 0; i <= 4; ++i) {
      for (int j = 0; i + j <= 4; ++j) {
        const Vector3<Rational> v = {Rational(i), Rational(j), Rational(4 - i - j)};
        const Rational difference = v.x * v.x - v.z * v.z;
        const Rational squares = v.y * v.y * dot(v, v) + weight * difference * difference;
        if (boundary_form(n, v, weight) != squares) return Outcome::holds();
      }
    }
  }
  return Outcome::violated("characteristic tensor along " + text(n) +
                           ": the complex domains of s = 1/3 and of s = 1/2 are both empty");
}

void boundary_parameter(const Trial& trial, Facts<Rational>& facts) {
  const auto values = characteristic_values(trial);
  if (!values) return facts.not_applicable(kNoFrame);
  const Values& l = *values;
  if (l[0] == l[1]) return facts.not_applicable("the larger characteristic eigenvalues are equal");
  Random random = trial.random;
  const Rational s = random.part(), two = facts.claimed(2), half = facts.claimed(1, 2);
  const Rational alpha = Rational(-3) * l[0] * random.part();
  const Rational weight = facts.claimed(1, 4) * (Rational(1) - s * s);
  facts.configuration(shape_of(l, {s, Rational(alpha / l[0])}));
  Squares m;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    m[i] = (weight * alpha * alpha + l[i] * alpha + l[i] * l[i]) /
           Rational(Rational(3) * l[i] * l[i] - half * squared_norm(l));
    inside = inside && m[i] >= 0;
  }
  facts.about([&] { return frame_place(l, s) + ", alpha = " + alpha.str(); });
  facts.equal("sum of the squares of the coordinates", m[0] + m[1] + m[2], facts.claimed(1));
  facts.equal("alpha of the point", alpha_of(l, m), alpha);
  facts.zero("boundary function of the point", boundary_at(l, m, boundary_weight(s)));
  // The interval of the values that belong to points.
  Rational low = -two * l[0] / (Rational(1) + s);
  if (s != 1) low = std::max(low, Rational(-two * l[1] / (Rational(1) - s)));
  const Rational high = -two * l[1] / (Rational(1) + s);
  facts.holds("interval of alpha", inside == (low <= alpha && alpha <= high));
}

Outcome one_parameter_two_points() {
  const Values l = {1, 1, -2};
  const Rational s = fraction(1, 3), sixth = fraction(1, 6), rest = 1 - sixth;
  const Squares first = {sixth, Rational(0), rest}, second = {Rational(0), sixth, rest};
  const Rational weight = boundary_weight(s);
  const bool both = boundary_at(l, first, weight) == 0 && boundary_at(l, second, weight) == 0 &&
                    alpha_of(l, first) == alpha_of(l, second);
  if (!both) return Outcome::holds();
  return Outcome::violated(frame_place(l, s) +
                           ": the boundary points with squares (1/6, 0, 5/6) and "
                           "(0, 1/6, 5/6) have the same alpha");
}

void bifurcation_mode(const Trial& trial, Facts<Rational>& facts) {
  const auto values = characteristic_values(trial);
  if (!values) return facts.not_applicable(kNoFrame);
  const Values& l = *values;
  if (l[1] == 0) return facts.not_applicable("the characteristic tensor has determinant 0");
  if (l[0] == l[1]) return facts.not_applicable("the larger characteristic eigenvalues are equal");
  const Rational critical = (l[0] - l[1]) / Rational(l[0] + l[1]);
  const Tensor n = tensor_of(l, trial.frame->eigenvectors);
  const Rational one = facts.claimed(1), weight = facts.claimed(1), three = facts.claimed(3);
  facts.about([&] { return frame_place(l, critical); });
  facts.equal("mu_0^2 + mode(T)^2",
              mode_squared_from_s2(Rational(critical * critical)) + weight * mode_squared(n), one);
  const Rational own = Rational(3) * l[1] / (l[0] - l[2]);
  facts.equal("s_0 from the parameter of |mode(T)|", critical * (three + own),
              three * (Rational(1) - own));
  Random random = trial.random;
  const Rational s = random.part(), of_s = boundary_weight(s);
  facts.configuration(shape_of(l, {s}));
  facts.about([&] { return frame_place(l, s); });
  facts.sign("boundary function at the minor eigenvector", boundary_at(l, kMinor, of_s),
             sign_of(Rational(critical - s)));
  facts.positive("at the major one", boundary_at(l, kMajor, of_s));
  facts.positive("at the medium one", boundary_at(l, kMedium, of_s));
  // Edges of the triangle of squares: across the major eigenvector, and across the medium one.
  const bool above = s > critical;
  const int first = facts.claimed_count(above ? 1 : 0), second = facts.claimed_count(above ? 1 : 2);
  if (s == 0 || s == critical) return;
  facts.holds("zeros on the edge across the major eigenvector",
              zeros_on_edge(l, s, kMedium, kMinor) == first);
  facts.holds("zeros on the edge across the medium eigenvector",
              zeros_on_edge(l, s, kMajor, kMinor) == second);
}

}  // namespace

std::vector<Statement> chart_statements() {
  const std::string frame =
      "a field of rank 4 whose characteristic tensor has rational "
      "eigenvectors; mu of a rational parameter s";
  return {
      {.id = "complex-domain-nesting",
       .paper = "Corollary 3",
       .claim =
           "For 0 <= mu_1 < mu_2 <= 1 the complex domain of mu_1 is a proper subset of that of "
           "mu_2.",
       .hypotheses = frame,
       .corrected = "A subset always, and a proper one unless the characteristic tensor has "
                    "determinant 0: then no vector is in a complex domain.",
       .special = "Characteristic tensors of determinant 0.",
       .flaws = {Flaw::exceptional},
       .check = nesting,
       .paper_at_witness = empty_complex_domains,
       .steps = {"mode-grows", "nested", "properly-nested"}},
      {.id = "boundary-parameter",
       .paper = "Lemma 4",
       .claim = "On an octant, the boundary of the complex domain has one point for each "
                "alpha = v.T v, T characteristic.",
       .hypotheses = frame,
       .corrected = "Only if the two larger eigenvalues of T differ, and for alpha in one closed "
                    "interval only; equal eigenvalues make alpha the same on the whole boundary.",
       .sharper = "From the larger of -2 l1/(1 + s) and -2 l2/(1 - s) to -2 l2/(1 + s), with the "
                  "squares ((1 - s^2) alpha^2/4 + l_i alpha + l_i^2) / (3 l_i^2 - 1/2).",
       .special = "Characteristic tensors of mode -1; at determinant 0 the interval is a point.",
       .flaws = {Flaw::wording, Flaw::exceptional},
       .check = boundary_parameter,
       .paper_at_witness = one_parameter_two_points,
       .steps = {"squares-of-alpha", "squares-factors", "range-of-alpha", "alpha-is-a-parameter",
                 "ends-of-range"},
       .reader = "Eight octants by reflection; that alpha runs through its interval once along the "
                 "arc in an octant."},
      {.id = "bifurcation-mode",
       .paper = "Theorem 5, the mode at which the topology changes",
       .claim = "The complex domain's boundary touches itself at mu_0 = sqrt(1 - mode(T)^2), T "
                "characteristic; in an octant it meets two edges once for larger modes, and one "
                "edge twice for smaller ones.",
       .hypotheses = frame + "; the three eigenvalues differ and none is 0",
       .sharper = "In the parameter s of the mode: s_0 = (l1 - l2)/(l1 + l2) = 3 (1 - r)/(3 + r), "
                  "where r is the parameter of |mode(T)|.",
       .special = "Determinant 0 or mode -1 of the characteristic tensor: nothing changes between "
                  "0 and 1.",
       .check = bifurcation_mode,
       .steps = {"bifurcation", "corner-at-bifurcation", "other-corners",
                 "edges-before-bifurcation", "edges-after-bifurcation", "edges-at-bifurcation",
                 "bifurcation-moebius"}},
      {.id = "singularities",
       .paper = "Theorem 5, end of the proof",
       .claim = "For mu = 0 the complex domain is empty and its boundary the two pairs of vectors "
                "across which the characteristic tensor is isotropic, at the stated coordinates.",
       .hypotheses = frame,
       .special = "At mode -1 of the characteristic tensor the two pairs are one.",
       .check = singularities,
       .steps = {"limit-at-mode-zero", "singularities-tensor", "singularities-plane"}},
  };
}

}  // namespace tensortopo::theory
