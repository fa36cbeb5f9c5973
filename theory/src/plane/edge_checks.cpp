// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Points of a mode along an edge.
#include "plane/checks.hpp"
#include "plane/plane.hpp"
#include "plane/polynomial.hpp"
#include "plane/real_zeros.hpp"
#include "tensors.hpp"

namespace tensortopo::theory {
namespace {

// Along an edge, in its weight x of the second end: N = |T|^2 and C = tr T^3 = 3 det T.
struct Edge {
  Polynomial norm, cube;

  Edge(const IntegerTensor& from, const IntegerTensor& to) {
    const auto t =
        tensor_cast<Polynomial>(from) + Polynomial::variable() * tensor_cast<Polynomial>(to - from);
    norm = inner(t, t);
    cube = inner(square(t), t);
  }
  /// 54 det^2 - mu^2 N^3, times the denominator of mu^2.
  Polynomial level(const Rational& mu_squared) const {
    return Polynomial(Integer(6 * denominator(mu_squared))) * cube * cube -
           Polynomial(Integer(numerator(mu_squared))) * norm * norm * norm;
  }
  /// It has the sign of the derivative of the mode.
  Polynomial slope() const {
    return Polynomial(2) * norm * derivative(cube) - Polynomial(3) * cube * derivative(norm);
  }
};

Polynomial without_repeated_zeros(const Polynomial& p) {
  return p.degree() < 1 ? p : quotient(p, greatest_common_divisor(p, derivative(p)));
}

// Which real zeros are strictly between 0 and 1.
std::vector<bool> inside_edge(const RealZeros& zeros) {
  const std::vector<Sign> above = zeros.signs(Polynomial::variable()),
                          below = zeros.signs(Polynomial(1) - Polynomial::variable());
  std::vector<bool> result;
  for (std::size_t i = 0; i < above.size(); ++i) {
    result.push_back(above[i] == Sign::positive && below[i] == Sign::positive);
  }
  return result;
}

// Different points of mode mu or -mu on the open edge, as roots of the polynomial of degree six.
int count_roots(const Edge& edge, const Rational& mu_squared) {
  const Polynomial p = without_repeated_zeros(edge.level(mu_squared));
  int count = 0;
  for (const bool inside : inside_edge(RealZeros(p))) count += inside ? 1 : 0;
  return count;
}

// The sign of mode - mu for sign 1, of -mode - mu for sign -1.
Sign side(Sign of_cube, Sign of_level, int sign) {
  const Sign same = sign > 0 ? of_cube : -of_cube;
  return same == Sign::positive ? of_level : Sign::negative;
}

// The same, from the signs at the ends and at the critical points, between which the mode is
// monotone.
int count_on_monotone_parts(const Edge& edge, const Rational& mu_squared) {
  const Polynomial level = edge.level(mu_squared);
  const RealZeros critical(without_repeated_zeros(edge.slope()));
  const std::vector<bool> inside = inside_edge(critical);
  const std::vector<Sign> of_level = critical.signs(level), of_cube = critical.signs(edge.cube);
  int count = 0;
  for (const int sign : {1, -1}) {
    Sign last = side(edge.cube.sign_at(Rational(0)), level.sign_at(Rational(0)), sign);
    const auto reach = [&](Sign next, bool is_inner) {
      if (last != Sign::zero && next != Sign::zero && last != next) ++count;
      if (is_inner && next == Sign::zero) ++count;
      last = next;
    };
    for (std::size_t i = 0; i < inside.size(); ++i) {
      if (inside[i]) reach(side(of_cube[i], of_level[i], sign), true);
    }
    reach(side(edge.cube.sign_at(Rational(1)), level.sign_at(Rational(1)), sign), false);
  }
  return count;
}

// xy + x xz + 2 yz for x from 0 to 3: its greatest mode is 4/5, at x = sqrt(5/2).
Edge touching_edge() {
  const IntegerTensor from = {0, 0, 0, 1, 2, 0}, to = {0, 0, 0, 1, 2, 3};
  return {from, to};
}

void edge_roots(const Trial& trial, Facts<Rational>& facts) {
  const auto plane = plane_of(trial.field);
  if (!plane) return facts.not_applicable("dependent tensors");
  Random random = trial.random;
  const Rational s = fraction(random.integer(1, 23), 24);
  const Rational mode = mode_squared_from_s2(Rational(s * s));
  for (std::size_t i = 0; i < 3; ++i) {
    if (Edge(plane->basis[i], plane->basis[(i + 1) % 3]).slope().is_zero()) {
      return facts.not_applicable("an edge of constant mode");
    }
  }
  const int six = facts.claimed_count(6), three = facts.claimed_count(3);
  static const Edge general(IntegerTensor{1, 2, -3, 1, 0, 0}, IntegerTensor{0, 1, -1, 2, 3, 1});
  for (std::size_t i = 0; i < 3; ++i) {
    const Edge edge(plane->basis[i], plane->basis[(i + 1) % 3]);
    const Polynomial slope = edge.slope();
    facts.about([&] {
      return "s = " + s.str() + ", edge " + std::to_string(i) + " of " + text(trial.field);
    });
    facts.holds("degree of the equation", edge.level(mode).degree() <= six);
    facts.holds("degree of the derivative", slope.degree() <= three);
    facts.holds("as many roots as the monotone parts show",
                count_roots(edge, mode) == count_on_monotone_parts(edge, mode));
  }
  facts.configuration_of(trial.field, {s});
  facts.about([&] { return "s = " + s.str(); });
  facts.holds("degree of the equation of a general edge", general.level(mode).degree() == six);
  facts.holds("degree of its derivative", general.slope().degree() == three);
  const Edge touching = touching_edge();
  const Rational top = fraction(16, 25);
  facts.holds("one root where the edge touches the curve",
              count_roots(touching, top) == facts.claimed_count(1));
  facts.holds("two a little below",
              count_roots(touching, Rational(top - fraction(1, 1000))) == facts.claimed_count(2));
}

}  // namespace

Check check_edge_roots() { return edge_roots; }

Outcome root_without_change_of_sign() {
  const Edge edge = touching_edge();
  const Polynomial level = edge.level(fraction(16, 25));
  const bool touches = count_roots(edge, fraction(16, 25)) == 1 && !is_squarefree(level);
  const bool no_change =
      level.sign_at(Rational(0)) == Sign::negative && level.sign_at(Rational(1)) == Sign::negative;
  if (!touches || !no_change) return Outcome::holds();
  return Outcome::violated(
      "the edge from [0, 0, 0, 1, 2, 0] to [0, 0, 0, 1, 2, 3] at mode 4/5: one point, at 3 times "
      "the weight = sqrt(5/2), a double root on both sides of which the mode is smaller");
}

}  // namespace tensortopo::theory
