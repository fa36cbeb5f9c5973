// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What depends on the eigenvalues of the characteristic tensor.
#include <algorithm>

#include "dominant_form.hpp"
#include "groups.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/theory/checks.hpp"

namespace tensortopo::theory {
namespace {

using Values = std::array<Rational, 3>;
// Squares of the coordinates of v in the frame of the characteristic tensor, of sum one.
using Squares = std::array<Rational, 3>;

Rational squared_norm(const Values& l) { return l[0] * l[0] + l[1] * l[1] + l[2] * l[2]; }
Rational alpha_of(const Values& l, const Squares& m) {
  return l[0] * m[0] + l[1] * m[1] + l[2] * m[2];
}

// The boundary function at v, times the squared norm; only the squares of v's coordinates enter.
Rational boundary_at(const Values& l, const Squares& m, const Rational& s) {
  const Rational alpha = alpha_of(l, m);
  const Rational beta = l[0] * l[0] * m[0] + l[1] * l[1] * m[1] + l[2] * l[2] * m[2];
  return squared_norm(l) / Rational(2) - beta + boundary_weight(s) * alpha * alpha;
}

std::string place(const Values& l, const Rational& s) {
  return "characteristic eigenvalues as " + text(Vector3<Rational>{l[0], l[1], l[2]}) +
         ", s = " + s.str();
}

// The eigenvalues of the characteristic tensor, if the trial knows them and they are right.
std::optional<Values> eigenvalues_of(const Trial& trial) {
  if (!trial.frame || field_rank(trial.field) != 4) return std::nullopt;
  const Tensor n = tensor_of(trial.frame->eigenvalues, trial.frame->eigenvectors);
  for (const auto& d : trial.field.vertex) {
    if (inner(n, to_tensor(d)) != 0) return std::nullopt;
  }
  return trial.frame->eigenvalues;
}

// Points of an open edge where the boundary function, quadratic along it, is zero.
int zeros_on_edge(const Values& l, const Rational& s, const Squares& from, const Squares& to) {
  Squares middle;
  for (std::size_t i = 0; i < 3; ++i) middle[i] = (from[i] + to[i]) / Rational(2);
  const Rational f = boundary_at(l, from, s), g = boundary_at(l, middle, s),
                 h = boundary_at(l, to, s);
  const Rational a = Rational(2) * (f + h) - Rational(4) * g, b = h - f - a;
  if (f * h < 0) return 1;
  const Rational discriminant = b * b - Rational(4) * a * f;
  const bool inside = a != 0 && -b / (a + a) > 0 && -b / (a + a) < 1;
  if (!inside || discriminant < 0) return 0;
  return discriminant == 0 ? 1 : 2;
}

const Squares kMajor = {1, 0, 0}, kMedium = {0, 1, 0}, kMinor = {0, 0, 1};

Outcome check_singularities(const Trial& trial) {
  const auto values = eigenvalues_of(trial);
  if (!values) return Outcome::not_applicable("no rational frame");
  const Values& l = *values;
  const Rational width = l[0] - l[2];
  const Squares m = {Rational((l[0] - l[1]) / width), Rational(0), Rational((l[1] - l[2]) / width)};
  const Rational none(0);
  if (boundary_at(l, m, none) != 0) return Outcome::violated(place(l, none));
  // A quarter of the squared gap of the projected tensor's eigenvalues: positive anywhere else.
  Random random = trial.random;
  Squares other = {random.part(), random.part(), random.part()};
  const Rational sum = other[0] + other[1] + other[2];
  if (sum == 0) return Outcome::holds();
  for (Rational& x : other) x = x / sum;
  const Rational value = boundary_at(l, other, none);
  if (value < 0 || (value == 0) != (other == m)) {
    return Outcome::violated(place(l, none) + ", squares of v " +
                             text(Vector3<Rational>{other[0], other[1], other[2]}));
  }
  return Outcome::holds();
}

// Halving the part of the edge between a singularity and the major eigenvector, until a point is in
// the complex domain of the larger parameter only.
bool found_between(const Values& l, const Rational& smaller, const Rational& larger) {
  Rational low = (l[1] - l[2]) / Rational(l[0] - l[2]), high(0), third = low;
  for (int step = 0; step < 200; ++step) {
    const Squares m = {Rational(Rational(1) - third), Rational(0), third};
    if (boundary_at(l, m, larger) >= 0) {
      high = third;
    } else if (boundary_at(l, m, smaller) < 0) {
      low = third;
    } else {
      return true;
    }
    third = (low + high) / Rational(2);
  }
  return false;
}

Outcome check_nesting(const Trial& trial) {
  const auto values = eigenvalues_of(trial);
  if (!values) return Outcome::not_applicable("no rational frame");
  Random random = trial.random;
  const auto [smaller, larger] = std::minmax({random.part(), random.part()});
  if (smaller == larger) return Outcome::not_applicable("equal modes drawn");
  const Tensor n = tensor_of(*values, trial.frame->eigenvectors);
  const bool neutral = (*values)[1] == 0;
  for (int i = 0; i < 4; ++i) {
    const Vector3<Rational> v = random_basis(random)[2];
    const bool in_smaller = boundary_form(n, v, boundary_weight(smaller)) < 0;
    const bool in_larger = boundary_form(n, v, boundary_weight(larger)) < 0;
    if ((in_smaller && !in_larger) || (neutral && in_larger)) {
      return Outcome::violated(place(*values, smaller) + " and " + larger.str() +
                               ", v = " + text(v));
    }
  }
  if (!neutral && !found_between(*values, smaller, larger)) {
    return Outcome::undecided("no vector found between " + place(*values, smaller) + " and " +
                              larger.str());
  }
  return Outcome::holds();
}

// For diag(1, 0, -1) the boundary function is y^2 |v|^2 + (1 - s^2) (x^2 - z^2)^2 / 4: nowhere
// negative. Forms of degree four that agree on the lattice of order four are equal.
Outcome empty_complex_domains() {
  const Tensor n = {1, 0, -1, 0, 0, 0};
  const Rational smaller = Rational(1) / Rational(3), larger = Rational(1) / Rational(2);
  for (const Rational& s : {smaller, larger}) {
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

Outcome check_boundary_parameter(const Trial& trial) {
  const auto values = eigenvalues_of(trial);
  if (!values) return Outcome::not_applicable("no rational frame");
  const Values& l = *values;
  if (l[0] == l[1]) return Outcome::not_applicable("two equal characteristic eigenvalues");
  Random random = trial.random;
  const Rational s = random.part(), two(2);
  const Rational alpha = Rational(-3) * l[0] * random.part();
  Squares m;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    m[i] = (boundary_weight(s) * alpha * alpha + l[i] * alpha + l[i] * l[i]) /
           Rational(Rational(3) * l[i] * l[i] - squared_norm(l) / two);
    inside = inside && m[i] >= 0;
  }
  const std::string witness = place(l, s) + ", alpha = " + alpha.str();
  if (m[0] + m[1] + m[2] != 1 || alpha_of(l, m) != alpha || boundary_at(l, m, s) != 0) {
    return Outcome::violated(witness);
  }
  // The interval of the values that belong to points.
  Rational low = -two * l[0] / (Rational(1) + s);
  if (s != 1) low = std::max(low, Rational(-two * l[1] / (Rational(1) - s)));
  const Rational high = -two * l[1] / (Rational(1) + s);
  return inside == (low <= alpha && alpha <= high) ? Outcome::holds() : Outcome::violated(witness);
}

Outcome one_parameter_two_points() {
  const Values l = {1, 1, -2};
  const Rational s = Rational(1) / Rational(3), sixth = Rational(1) / Rational(6), rest = 1 - sixth;
  const Squares first = {sixth, Rational(0), rest}, second = {Rational(0), sixth, rest};
  const bool both = boundary_at(l, first, s) == 0 && boundary_at(l, second, s) == 0 &&
                    alpha_of(l, first) == alpha_of(l, second);
  if (!both) return Outcome::holds();
  return Outcome::violated(place(l, s) +
                           ": the boundary points with squares (1/6, 0, 5/6) and "
                           "(0, 1/6, 5/6) have the same alpha");
}

}  // namespace

Check check_bifurcation(const Rational& weight) {
  return [weight](const Trial& trial) {
    const auto values = eigenvalues_of(trial);
    if (!values) return Outcome::not_applicable("no rational frame");
    const Values& l = *values;
    if (l[1] == 0 || l[0] == l[1]) return Outcome::not_applicable("neutral or degenerate");
    const Rational critical = (l[0] - l[1]) / Rational(l[0] + l[1]);
    const Rational det = l[0] * l[1] * l[2], size = squared_norm(l);
    const Rational mode_squared = Rational(54) * det * det / (size * size * size);
    if (mode_squared_from_s2(Rational(critical * critical)) + weight * mode_squared != 1) {
      return Outcome::violated(place(l, critical));
    }
    Random random = trial.random;
    const Rational s = random.part();
    const Rational at_minor = boundary_at(l, kMinor, s);
    if (sign_of(at_minor) != sign_of(Rational(critical - s)) || boundary_at(l, kMajor, s) <= 0 ||
        boundary_at(l, kMedium, s) <= 0) {
      return Outcome::violated(place(l, s));
    }
    if (s == 0 || s == critical) return Outcome::holds();
    // Edges of the triangle of squares: across the major eigenvector, and across the medium one.
    const int major = zeros_on_edge(l, s, kMedium, kMinor);
    const int medium = zeros_on_edge(l, s, kMajor, kMinor);
    const bool as_claimed = s > critical ? major == 1 && medium == 1 : major == 0 && medium == 2;
    return as_claimed ? Outcome::holds() : Outcome::violated(place(l, s));
  };
}

std::vector<Statement> chart_statements() {
  const std::string frame =
      "a field of rank 4 whose characteristic tensor has rational "
      "eigenvectors; mu of a rational parameter s";
  return {
      {"complex-domain-nesting", "Corollary 3",
       "For 0 <= mu_1 < mu_2 <= 1 the complex domain of mu_1 is a proper subset of that of mu_2.",
       frame,
       "A subset always, and a proper one unless the characteristic tensor has determinant 0: "
       "then no vector is in a complex domain.",
       check_nesting, empty_complex_domains},
      {"boundary-parameter", "Lemma 4",
       "On an octant, the boundary of the complex domain has one point for each "
       "alpha = v.T v, T characteristic.",
       frame,
       "Only if the two larger eigenvalues of T differ, and for alpha in one closed interval "
       "only; equal eigenvalues make alpha the same on the whole boundary.",
       check_boundary_parameter, one_parameter_two_points},
      {"bifurcation-mode",
       "Theorem 5, the mode at which the topology changes",
       "The complex domain's boundary touches itself at mu_0 = sqrt(1 - mode(T)^2), T "
       "characteristic; in an octant it meets two edges once for larger modes, and one edge twice "
       "for smaller ones.",
       frame + "; the three eigenvalues differ and none is 0",
       "",
       check_bifurcation(),
       {}},
      {"singularities",
       "Theorem 5, end of the proof",
       "For mu = 0 the complex domain is empty and its boundary the two pairs of vectors across "
       "which the characteristic tensor is isotropic, at the stated coordinates.",
       frame,
       "",
       check_singularities,
       {}},
  };
}

}  // namespace tensortopo::theory
