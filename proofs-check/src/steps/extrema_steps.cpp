// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Critical points of the mode on a plane: det(u T1 + v T2 + w T3) on the unit sphere, for an
// orthonormal basis T1, T2, T3 of the tensors of the plane. (f, g, h) is the gradient of det.
#include <algorithm>

#include "algebra/univariate.hpp"
#include "certificates/step.hpp"
#include "steps/common/glued_cube.hpp"
#include "steps/common/plane_determinant.hpp"

namespace proofs {
namespace {

/// In the variables named together.
int degree_in(Polynomial f, const std::vector<std::string>& names) {
  const auto t = variable("t");
  for (const std::string& name : names) f = f.with(name, t * variable(name));
  return static_cast<int>(f.coefficients_of("t").size()) - 1;
}

std::vector<Polynomial> gradient_of_determinant(Constants& k) {
  const PlaneDeterminant d = PlaneDeterminant::any();
  return {d.u * d.f + d.v * d.g + d.w * d.h - k(3) * d.value};
}

void chart_is_quadratic(Checks& c) {
  const PlaneDeterminant d = PlaneDeterminant::any();
  for (const Polynomial& f : {d.f, d.g, d.h})
    c.equal(degree_in(f.with("w", 1), {"u", "v"}), c.k(2));
}

void chart_is_not_cubic(Checks& c) {
  const PlaneDeterminant d(plane_of_shears());
  c.equal(d.value, c.k(2) * d.u * d.v * d.w);
  for (const Polynomial& f : {d.f, d.g, d.h})
    c.that(degree_in(f.with("w", 1), {"u", "v"}) < 3, "a cubic polynomial after all");
}

std::vector<Polynomial> third_equation(Constants& k) {
  const auto u = variable("u"), v = variable("v"), w = variable("w"), f = variable("f"),
             g = variable("g"), h = variable("h");
  return {w * (u * g - v * f) + k(1) * u * (v * h - w * g) + k(1) * v * (w * f - u * h)};
}

void plane_is_orthonormal(Checks& c, const std::array<Matrix3, 3>& basis,
                          const Polynomial& squared_norm) {
  for (std::size_t i = 0; i < 3; ++i) {
    c.vanishes(trace(basis[i]));
    for (std::size_t j = 0; j < 3; ++j)
      c.equal(inner(basis[i], basis[j]), i == j ? squared_norm : Polynomial());
  }
}

PlaneDeterminant example() { return PlaneDeterminant(general_plane()); }

/// Elimination of v from the two equations in the chart w = 1.
Polynomial eliminated(const PlaneDeterminant& d) {
  const Polynomial first = d.v * d.h - d.g, second = d.f - d.u * d.h;
  return resultant(first.with("w", 1), second.with("w", 1), "v");
}

void seven_solutions(Checks& c) {
  // At infinity of the chart both equations have the common factor h(u, v, 0), of degree two.
  const PlaneDeterminant d = PlaneDeterminant::any();
  const auto t = variable("t");
  const auto top = [&](const Polynomial& f) {
    return f.with("w", 1).with("u", t * d.u).with("v", t * d.v).coefficients_of("t").back();
  };
  const Polynomial at_infinity = d.h.with("w", 0);
  c.equal(top(d.v * d.h - d.w * d.g), c.k(1) * d.v * at_infinity);
  c.equal(top(d.w * d.f - d.u * d.h), c.k(-1) * d.u * at_infinity);
  c.equal(degree_in(at_infinity, {"u", "v"}), c.k(2));
  // Nine less these two are reached: seven different solutions of an example.
  c.equal(static_cast<int>(count_complex_roots(eliminated(example()), "u")), c.k(7));
}

void not_nine_solutions(Checks& c) {
  plane_is_orthonormal(c, general_plane(), c.k(12));
  c.equal(degree_in(eliminated(example()), {"u"}), c.k(7));
}

void degenerate_solutions(Checks& c) {
  // Degenerate where |T|^6 = 54 det^2; |T|^2 is 12 (u^2 + v^2 + w^2).
  const PlaneDeterminant d = example();
  const Polynomial norm = Polynomial(12) * (square(d.u) + square(d.v) + 1);
  const Polynomial discriminant = cube(norm) - Polynomial(54) * square(d.value.with("w", 1));
  const Polynomial critical = eliminated(d);
  const Polynomial degenerate = resultant((d.f - d.u * d.h).with("w", 1), discriminant, "v");
  const auto shared = count_common_roots(critical, degenerate, "u");
  c.equal(static_cast<int>(shared), c.k(4));
  c.equal(static_cast<int>(count_complex_roots(critical, "u") - shared), c.k(3));
}

void solutions_in_projective_plane(Checks& c) {
  // The equations have degrees 3, 3 and 2; the spurious ones solve h(u, v, 0) = 0 and u^2+v^2 = 1.
  const PlaneDeterminant d = PlaneDeterminant::any();
  const std::vector<std::string> all{"u", "v", "w"};
  const int sphere = degree_in(square(d.u) + square(d.v) + square(d.w), all);
  const int solutions =
      degree_in(d.v * d.h - d.w * d.g, all) * degree_in(d.w * d.f - d.u * d.h, all) * sphere;
  const int spurious = degree_in(d.h.with("w", 0), all) * sphere;
  c.equal(solutions, c.k(18));
  c.equal(spurious, c.k(4));
  c.equal((solutions - spurious) / 2, c.k(7));
}

void critical_without_w(Checks& c) {
  // With w = 0 the first two equations leave h = 0, and then the third decides.
  const auto u = variable("u"), v = variable("v"), f = variable("f"), g = variable("g"),
             h = variable("h");
  const Vector3 condition = cross({f, g, h}, {u, v, 0});
  c.equal(condition[0], c.k(-1) * v * h);
  c.equal(condition[1], c.k(1) * u * h);
  c.equal(condition[2], c.k(1) * (v * f - u * g));
}

void extremum_without_w(Checks& c) {
  const std::array<Matrix3, 3> basis = plane_with_degenerate_first();
  plane_is_orthonormal(c, basis, c.k(6));
  const PlaneDeterminant d(basis);
  const auto at_first = [](const Polynomial& f) {
    return f.with("u", 1).with("v", 0).with("w", 0);
  };
  c.vanishes(at_first(d.g));
  c.vanishes(at_first(d.h));
  c.equal(at_first(d.f), c.k(6));
  // Of mode 1, which no tensor exceeds: 54 det^2 = |T|^6, det > 0.
  c.equal(Polynomial(54) * square(at_first(d.value)), cube(c.k(6)));
  c.is_positive(at_first(d.value));
}

void critical_in_chart(Checks& c) {
  // N = |T|^2 and D = det T of the plane: N grad D - (3/2) D grad N has the sign of the gradient of
  // the mode, and no component along (u, v, w); two components decide where the third has a factor.
  const PlaneDeterminant d = PlaneDeterminant::any();
  const Polynomial norm = square(d.u) + square(d.v) + square(d.w);
  Polynomial along;
  for (const std::string name : {"u", "v", "w"})
    along += variable(name) *
             (c.k(2) * norm * d.value.derivative(name) - c.k(3) * d.value * norm.derivative(name));
  c.vanishes(along);
}

void critical_at_infinity(Checks& c) {
  // T = [[0,1,x],[1,0,y],[x,y,0]]: det = 2 x y, and on the sphere 2 u v w with u the weight of T0.
  const PlaneDeterminant d(plane_of_shears());
  plane_is_orthonormal(c, plane_of_shears(), c.k(2));
  c.equal(d.value, c.k(2) * d.u * d.v * d.w);
  for (const Vector3& p : {Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
    const auto at = [&](const Polynomial& f) {
      return f.with("u", p[0]).with("v", p[1]).with("w", p[2]);
    };
    const Vector3 condition = cross({at(d.f), at(d.g), at(d.h)}, p);
    c.all_vanish({condition[0], condition[1], condition[2]});
  }
}

/// Pairs of antipodal solutions on the sphere that are critical: all less the spurious ones.
int critical_pairs() {
  const PlaneDeterminant d = PlaneDeterminant::any();
  const std::vector<std::string> all{"u", "v", "w"};
  const int sphere = degree_in(square(d.u) + square(d.v) + square(d.w), all);
  const int solutions =
      degree_in(d.v * d.h - d.w * d.g, all) * degree_in(d.w * d.f - d.u * d.h, all) * sphere;
  return (solutions - degree_in(d.h.with("w", 0), all) * sphere) / 2;
}

/// The Euler characteristic of the sphere, on a cube.
int sphere_characteristic() {
  return static_cast<int>(glue_opposites(3, {}, 0).euler_characteristic());
}

/// The most extrema for so many critical points, if there are so many more extrema than saddles.
int most_extrema(int critical_points, int excess) {
  int most = 0;
  for (int extrema = 0; extrema <= critical_points; ++extrema) {
    const int saddles = extrema - excess;
    if (saddles >= 0 && extrema + saddles <= critical_points) most = std::max(most, extrema);
  }
  return most;
}

void at_most_four(Checks& c) {
  // Morse theory: extrema less saddles are the Euler characteristic; antipodes are one tensor.
  const int points = 2 * critical_pairs(), excess = sphere_characteristic();
  c.equal(points, c.k(14));
  c.equal(excess, c.k(2));
  c.equal(most_extrema(points, excess), c.k(8));
  c.equal(rational(1, 2) * Polynomial(most_extrema(points, excess)), c.k(4));
}

void infinitely_many(Checks& c) {
  // T = [[1+x,y,0],[y,1-x,0],[0,0,-2]]: mode 1 on the circle x^2 + y^2 = 9.
  const auto x = variable("x"), y = variable("y");
  const Matrix3 t = symmetric(Polynomial(1) + x, Polynomial(1) - x, -2, y, 0, 0);
  const auto on_circle = [&](const Polynomial& f) { return f.with_square("y", c.k(9) - x * x); };
  c.vanishes(trace(t));
  c.equal(on_circle(determinant(t)), c.k(16));
  c.equal(Polynomial(54) * square(on_circle(determinant(t))), on_circle(cube(inner(t, t))));
}

/// The fewest changes of sign around a closed curve that has points of both signs: arcs of like
/// signs alternate, so their number is even and not 0.
int zeros_between_signs() {
  int fewest = 8;
  for (unsigned signs = 1; signs < 15; ++signs) {
    int changes = 0;
    for (unsigned i = 0; i < 4; ++i)
      changes += (signs >> i & 1) != (signs >> ((i + 1) % 4) & 1) ? 1 : 0;
    fewest = std::min(fewest, changes);
  }
  return fewest;
}

void sharper_numbers(Checks& c) {
  // In the projective plane there is one extremum more than saddles, seven critical points at most,
  // and at least two degenerate points, all extrema.
  const auto claimed = [&](long value) { return static_cast<int>(c.k(value).constant().get_d()); };
  const int pairs = claimed(7), excess = claimed(1), least = claimed(2);
  c.equal(critical_pairs(), pairs);
  // Half that of the sphere, which covers the projective plane twice.
  c.equal(sphere_characteristic(), 2 * excess);
  // common-zero: of three orthonormal zeros of the first form the second has the sum 0, so it has
  // values of both signs, or is zero at all three; the zeros of the first are a closed curve.
  c.that(zeros_between_signs() == least, "not as many zeros between two signs on a closed curve");
  std::vector<int> extrema;
  for (int number = least; number <= pairs; ++number)
    if (number + (number - excess) <= pairs) extrema.push_back(number);
  c.equal(static_cast<int>(extrema.size()), c.k(3));
  c.equal(extrema.front(), c.k(2));
  c.equal(extrema.back(), c.k(4));
}

}  // namespace

std::vector<Step> extrema_steps() {
  const Place place = Place::theorem6;
  return {
      identity(place, "gradient-of-determinant", "u f + v g + w h = 3 det",
               gradient_of_determinant),
      correction(
          place, "chart-degree", Kind::count,
          {"in the chart w = 1 the derivatives of det are cubic polynomials", "quadratic ones",
           "T1, T2, T3 the three shears: det = 2 u v w, whose derivatives are 2 v, 2 u and "
           "2 u v"},
          chart_is_quadratic, chart_is_not_cubic),
      identity(
          place, "third-equation",
          "w (u g - v f) = -u (v h - w g) - v (w f - u h): where w is not 0 the third equation "
          "follows, whether h is 0 or not",
          third_equation),
      claim(place, "solutions-on-sphere", Kind::count,
            "degrees 3, 3, 2: 18 solutions on the sphere, 4 of them spurious, the others in 7 "
            "antipodal pairs",
            solutions_in_projective_plane),
      correction(place, "solutions-in-chart", Kind::count,
                 {"the two equations in the chart w = 1 have nine solutions",
                  "seven: at infinity they have the common factor h(u, v, 0), so two of nine are "
                  "not in the chart; an example has seven different ones",
                  "the plane of [[-1,1,1],[1,-1,-1],[1,-1,2]], [[0,-1,-1],[-1,0,-2],[-1,-2,0]], "
                  "[[-2,1,-1],[1,2,0],[-1,0,0]], orthogonal and of squared norm 12: "
                  "eliminating v "
                  "leaves a polynomial of degree 7"},
                 seven_solutions, not_nine_solutions),
      claim(place, "degenerate-solutions", Kind::count,
            "four of the seven solutions are degenerate tensors, three are not: so in the example "
            "above",
            degenerate_solutions),
      correction(place, "solutions-without-w", Kind::identity,
                 {"solutions with w = 0 are spurious",
                  "those are that do not satisfy the third equation u g = v f, which is all that "
                  "is left for w = h = 0",
                  "T1 = diag(2,-1,-1), T2 = E12+E13+E23, T3 = diag(0,1,-1)+E12-E13, all of squared "
                  "norm 6 and orthogonal: (1, 0, 0) is a maximum, of mode 1"},
                 critical_without_w, extremum_without_w),
      correction(
          place, "critical-at-infinity", Kind::identity,
          {"critical points of the mode on the plane and on the sphere correspond one to one",
           "those with a weight of T0 other than 0 do: 2 N grad D - 3 D grad N, with N = "
           "|T|^2 and D = det T, has no component along (u, v, w)",
           "T = [[0,1,x],[1,0,y],[x,y,0]]: det = 2 u v w, critical at (0,1,0) and (0,0,1), "
           "which are no points of the plane"},
          critical_in_chart, critical_at_infinity),
      correction(
          place, "at-most-four", Kind::count,
          {"every plane has at most four extrema of the mode",
           "if the critical points are isolated and simple: at most 14 on the sphere and two "
           "more extrema than saddles leave at most 8 extrema, 4 in the plane",
           "T = [[1+x,y,0],[y,1-x,0],[0,0,-2]]: det = 16 and 54 det^2 = |T|^6, so mode 1, on "
           "the circle x^2 + y^2 = 9"},
          at_most_four, infinitely_many),
      claim(place, "numbers-of-extrema", Kind::count,
            "isolated and simple critical points, at least two of them degenerate tensors: 2, 3 or "
            "4 extrema in the projective plane, with one saddle less (not in the paper)",
            sharper_numbers),
  };
}

}  // namespace proofs
