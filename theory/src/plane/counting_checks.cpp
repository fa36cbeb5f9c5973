// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// How many critical points there are in a plane, and of which kinds.
#include "plane/checks.hpp"
#include "plane/pencil.hpp"
#include "plane/real_zeros.hpp"
#include "plane/witness_planes.hpp"
#include "tensors.hpp"

namespace tensortopo::theory {
namespace {

const std::string kDependent = "dependent tensors";

std::string place(const Trial& trial) {
  const TriangleField<Rational> face = first_face(trial.field);
  std::string words = "plane of";
  for (const auto& d : face.vertex) words += " " + text(to_tensor(d));
  return words;
}

CriticalCounts counts_of(const WitnessPlane& witness) {
  const Plane plane = *plane_of(witness.face());
  return count(real_points(plane, critical_system(plane).critical));
}

int real_count(const PointFamily& family) {
  if (family.count() <= 0) return 0;
  return static_cast<int>(RealZeros(family.parameters).count());
}

// Whether the mode is critical at every point of the family.
bool is_critical(const Plane& plane, const PointFamily& family) {
  const auto minors = critical_minors(plane.basis, family.tensor(plane));
  return divides(family.parameters, minors.x) && divides(family.parameters, minors.y) &&
         divides(family.parameters, minors.z);
}

// Points of the family, complex ones too, at which the tensor is degenerate.
int degenerate_count(const Plane& plane, const PointFamily& family) {
  const Polynomial form = degeneracy_form(family.tensor(plane));
  return greatest_common_divisor(family.parameters, form).degree();
}

void planar_extrema(const Trial& trial, Facts<Rational>& facts) {
  const auto plane = plane_of(trial.field);
  if (!plane) return facts.not_applicable(kDependent);
  const CriticalSystem system = critical_system(*plane);
  if (system.position != Position::general) return facts.not_applicable(words(system.position));
  const CriticalCounts counts = count(real_points(*plane, system.critical));
  static const CriticalCounts four = counts_of(three_fold_ring()),
                              three = counts_of(smooth_maximum()),
                              two = counts_of(ring_with_two_extrema());
  facts.about([&] { return text(counts) + " in the " + place(trial); });
  const int most = facts.claimed_count(4), least = facts.claimed_count(2);
  facts.holds("no more extrema than four", counts.extrema <= most);
  facts.holds("as many in a plane that has four", four.extrema == most);
  facts.holds("no fewer extrema than two", counts.extrema >= least);
  facts.holds("as few in a plane that has two", two.extrema == least);
  const int excess = facts.claimed_count(1), smooth = facts.claimed_count(1);
  facts.holds("one extremum more than saddles", counts.extrema - counts.saddles == excess);
  facts.holds("no more extrema that are not degenerate than one",
              counts.nondegenerate_extrema <= smooth);
  facts.holds("as many in a plane that has one", three.nondegenerate_extrema == smooth);
  facts.holds("every degenerate point is an extremum",
              counts.degenerate + counts.nondegenerate_extrema == counts.extrema);
  facts.holds("no singular Hessian at a simple solution", counts.singular == 0);
}

void planar_pairs(const Trial& trial, Facts<Rational>& facts) {
  const auto plane = plane_of(trial.field);
  if (!plane) return facts.not_applicable(kDependent);
  const CriticalSystem system = critical_system(*plane);
  const DegenerateSystem degenerate = degenerate_system(*plane);
  const PencilSystem pencil = pencil_system(*plane);
  for (const Position p : {system.position, degenerate.position, pencil.position}) {
    if (p != Position::general) return facts.not_applicable(words(p));
  }
  facts.about([&] { return place(trial); });
  const int seven = facts.claimed_count(7), four = facts.claimed_count(4),
            three = facts.claimed_count(3);
  facts.holds("seven solutions of the three equations", system.critical.count() == seven);
  facts.holds("they solve all three", is_critical(*plane, system.critical));
  facts.holds("four of them degenerate", degenerate_count(*plane, system.critical) == four);
  facts.holds("four common zeros of the forms of the complement",
              degenerate.points.count() == four);
  facts.holds("they are critical", is_critical(*plane, degenerate.points));
  facts.holds("they are degenerate", degenerate_count(*plane, degenerate.points) == four);
  facts.holds("three zeros of the complement's cubic", pencil.cubic.degree() == three);
  facts.holds("each has its point", pencil.regular.count() + pencil.neutral.count() == three);
  for (const PointFamily& points : {pencil.regular, pencil.neutral}) {
    facts.holds("these points are critical", is_critical(*plane, points));
    facts.holds("none of them is degenerate", degenerate_count(*plane, points) == 0);
  }
  const int real = real_count(system.critical), real_degenerate = real_count(degenerate.points),
            others = real_count(pencil.regular) + real_count(pencil.neutral);
  facts.holds("the same number of real points both ways", real == real_degenerate + others);
  facts.holds(
      "three, five or seven real points, the last if four are degenerate",
      real_degenerate == 4 ? others == 3 : real_degenerate == 2 && (others == 1 || others == 3));
}

void degenerate_points(const Trial& trial, Facts<Rational>& facts) {
  const auto plane = plane_of(trial.field);
  if (!plane) return facts.not_applicable(kDependent);
  const DegenerateSystem system = degenerate_system(*plane);
  if (system.position != Position::general) {
    return facts.not_applicable("degenerate points coincide or fill a curve");
  }
  const auto real_in = [](const WitnessPlane& witness) {
    return real_count(degenerate_system(*plane_of(witness.face())).points);
  };
  static const int as_few = real_in(ring_with_two_extrema()), as_many = real_in(off_diagonal());
  facts.about([&] { return place(trial); });
  const int least = facts.claimed_count(2), most = facts.claimed_count(4);
  const int real = real_count(system.points);
  facts.holds("two degenerate points or four", real == least || real == most);
  facts.holds("two in a plane that has two", as_few == least);
  facts.holds("four in a plane that has four", as_many == most);
  facts.holds("four if three neutral tensors are orthogonal to the plane, two if one is",
              neutral_normals(*plane) == (real == 4 ? 3 : 1));
}

}  // namespace

Check check_planar_extrema() { return planar_extrema; }
Check check_planar_pairs() { return planar_pairs; }
Check check_degenerate_points() { return degenerate_points; }

// The complement is spanned by diag(-2, 1, 1) + yz and xy, with the forms (y + z)^2 - 2 x^2 and
// 2 x y: zeros (0, 1, -1), twice, and (1, 0, +-sqrt(2)).
Outcome three_degenerate_points() {
  const TriangleField<Rational> face = {{deviator(Tensor{0, 1, -1, 0, 0, 0}),
                                         deviator(Tensor{0, 0, 0, 0, 0, 1}),
                                         deviator(Tensor{2, -1, -1, 0, 3, 0})}};
  const Tensor first = {-2, 1, 1, 0, 1, 0}, second = {0, 0, 0, 1, 0, 0};
  for (const auto& d : face.vertex) {
    const Tensor t = to_tensor(d);
    if (inner(t, first) != 0 || inner(t, second) != 0) return Outcome::holds();
  }
  // Forms of degree two that agree at (i, j, 2 - i - j) are equal.
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; i + j <= 2; ++j) {
      const Rational x(i), y(j), z(2 - i - j), sum = y + z, two(2);
      const Vector3<Rational> e = {x, y, z};
      if (dot(e, first * e) != sum * sum - two * x * x || dot(e, second * e) != two * x * y) {
        return Outcome::holds();
      }
    }
  return Outcome::violated(
      "[0, 1, -1, 0, 0, 0] [0, 0, 0, 0, 0, 1] [2, -1, -1, 0, 3, 0]: dominant eigenvectors are the "
      "common zeros of (y + z)^2 - 2 x^2 and 2 x y: (0, 1, -1), a double one, (1, 0, sqrt(2)) and "
      "(1, 0, -sqrt(2)); three degenerate points");
}

// The complement is spanned by diag(1, -1, 0) and xy: (x^2 - y^2)^2 + (2 x y)^2 = (x^2 + y^2)^2.
Outcome one_degenerate_point() {
  const std::array<Tensor, 3> plane = {Tensor{1, 1, -2, 0, 0, 0}, Tensor{0, 0, 0, 0, 0, 1},
                                       Tensor{0, 0, 0, 0, 1, 0}};
  const Tensor first = {1, -1, 0, 0, 0, 0}, second = {0, 0, 0, 1, 0, 0};
  for (const Tensor& t : plane) {
    if (inner(t, first) != 0 || inner(t, second) != 0) return Outcome::holds();
  }
  // Forms of degree four that agree at (i, j, 4 - i - j) are equal.
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; i + j <= 4; ++j) {
      const Vector3<Rational> e = {Rational(i), Rational(j), Rational(4 - i - j)};
      const Rational size = e.x * e.x + e.y * e.y;
      if (squared(dot(e, first * e)) + squared(dot(e, second * e)) != size * size) {
        return Outcome::holds();
      }
    }
  return Outcome::violated(
      "[1, 1, -2, 0, 0, 0] [0, 0, 0, 0, 0, 1] [0, 0, 0, 0, 1, 0]: dominant eigenvectors are the "
      "common zeros of x^2 - y^2 and 2 x y, whose squares have the sum (x^2 + y^2)^2: (0, 0, 1) "
      "alone, one degenerate point");
}

Outcome extrema_along_a_circle() {
  const WitnessPlane& witness = ring();
  const std::array<std::array<Rational, 2>, 5> points = {
      {{3, 0}, {0, 3}, {-3, 0}, {0, -3}, {fraction(9, 5), fraction(12, 5)}}};
  for (const auto& [x, y] : points) {
    const Tensor t = witness.tensors[0] + x * witness.tensors[1] + y * witness.tensors[2];
    if (mode_squared(t) != 1 || determinant(t) <= 0) return Outcome::holds();
  }
  return Outcome::violated(witness.name +
                           ": the mode is 1, its maximum, at (3, 0), (0, 3), (-3, 0), (0, -3) and "
                           "(9/5, 12/5)");
}

Outcome critical_points_along_a_circle() {
  const Plane plane = *plane_of(ring().face());
  if (critical_system(plane).position != Position::not_isolated) return Outcome::holds();
  return Outcome::violated(ring().name +
                           ": the resultant of the equations is 0, and the critical "
                           "points are more than seven");
}

}  // namespace tensortopo::theory
