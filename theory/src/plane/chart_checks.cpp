// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The equations of critical points in a chart, and where the chart ends.
#include <algorithm>

#include "plane/checks.hpp"
#include "plane/critical_points.hpp"
#include "plane/elimination.hpp"
#include "plane/witness_planes.hpp"
#include "tensors.hpp"

namespace tensortopo::theory {
namespace {

using TensorTriple = std::array<IntegerTensor, 3>;

// Without the parts along the others, times a number: an orthonormal basis but for lengths, which
// are roots and do not matter in a chart.
TensorTriple orthogonal(const TensorTriple& basis) {
  const auto [t1, t2, t3] = basis;
  const IntegerTensor u = t1;
  const IntegerTensor v = inner(u, u) * t2 - inner(t2, u) * u;
  const Integer uu = inner(u, u), vv = inner(v, v);
  const IntegerTensor w = (uu * vv) * t3 - (inner(t3, u) * vv) * u - (inner(t3, v) * uu) * v;
  return {u, v, w};
}

// The number of solutions of the first two equations with w = 1, by a projection in which none is
// lost; -1 if they are solved by all points with w = 0.
int solutions_in_chart(const TensorTriple& basis) {
  const auto [u, v, w] = orthogonal(basis);
  // With w = 0 they say that h is zero, a quadratic form.
  for (int k = 0; k < 3; ++k) {
    const Elimination e = eliminate({u, v + Integer(k) * u, w});
    if (e.proper) return e.all.degree();
  }
  return -1;
}

// The largest degree of f, g and h along a line with w = 1.
int gradient_degree(const TensorTriple& basis) {
  const auto [u, v, w] = orthogonal(basis);
  int degree = 0;
  for (const IntegerTensor& direction : {u, v, u + v}) {
    const auto t =
        Polynomial::variable() * tensor_cast<Polynomial>(direction) + tensor_cast<Polynomial>(w);
    const auto f = products(square(t), basis);
    degree = std::max({degree, f.x.degree(), f.y.degree(), f.z.degree()});
  }
  return degree;
}

// Points of the family that are combinations of the first two tensors.
int without_third(const PointFamily& family) {
  return greatest_common_divisor(family.parameters, family.weights.z).degree();
}

int at_infinity(const PointFamily& family) {
  return greatest_common_divisor(family.parameters, family.weight_sum()).degree();
}

// Points that have a place in the plane: no common zero with the sum of the weights.
int in_plane(const PointFamily& family) {
  const Polynomial common = greatest_common_divisor(family.parameters, family.weight_sum());
  return family.parameters.degree() - common.degree();
}

// Whether the derivatives of the mode along two sides of the triangle vanish, as polynomials in the
// parameter: 2 N dD - 3 D dN with N = |T|^2 and D = tr T^3 / 3, D = det.
bool is_critical_in_plane(const Plane& plane, const PointFamily& family) {
  const auto t = family.tensor(plane);
  const auto squared_tensor = square(t);
  const Polynomial size = inner(t, t), cube = inner(squared_tensor, t);
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
    const auto along = tensor_cast<Polynomial>(plane.basis[i] - plane.basis[0]);
    const Polynomial slope = size * inner(squared_tensor, along) - cube * inner(t, along);
    if (!divides(family.parameters, slope)) return false;
  }
  return true;
}

// A maximum first, and none of the other critical points a combination of the first two.
TensorTriple basis_from_maximum() {
  const TensorTriple span = plane_of(off_diagonal_shifted().span())->basis;
  return {span[0], span[1] + Integer(2) * span[2], span[2]};
}

// Three saddles.
TensorTriple basis_of_axes() { return plane_of(off_diagonal().span())->basis; }

void spurious_solutions(const Trial& trial, Facts<Rational>& facts) {
  const auto plane = plane_of(trial.field);
  if (!plane) return facts.not_applicable("dependent tensors");
  const CriticalSystem system = critical_system(*plane);
  if (system.position != Position::general) return facts.not_applicable(words(system.position));
  if (without_third(system.critical) != 0) {
    return facts.not_applicable("a critical point with w = 0");
  }
  static const int one_lost = solutions_in_chart(basis_from_maximum()),
                   two_lost = solutions_in_chart(basis_of_axes());
  facts.about([&] { return "first three tensors of " + text(trial.field); });
  const int nine = facts.claimed_count(9), seven = facts.claimed_count(7),
            two = facts.claimed_count(2);
  const int in_chart = solutions_in_chart(plane->basis);
  facts.holds("nine solutions of two of the equations", system.solutions == nine);
  facts.holds("seven of them with w = 1", in_chart == seven);
  facts.holds("two of them spurious", system.spurious == two);
  facts.holds("these at w = 0", system.solutions - in_chart == two);
  facts.holds("f, g and h of degree two", gradient_degree(plane->basis) == facts.claimed_count(2));
  facts.holds("six with w = 1 where a critical point is at w = 0",
              one_lost == facts.claimed_count(6));
  facts.holds("five where two critical points are", two_lost == facts.claimed_count(5));
}

const auto redundancy = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  Random random = trial.random;
  const Vector3<Rational> point = {random.fraction(), random.fraction(),
                                   Rational(random.nonzero(9))};
  const auto tensor = [&](std::size_t i) { return facts.tensor(to_tensor(trial.field.vertex[i])); };
  const auto t1 = tensor(0), t2 = tensor(1), t3 = tensor(2);
  const auto [u, v, w] = facts.vector(point);
  const auto t = square(u * t1 + v * t2 + w * t3);
  const Scalar f = inner(t, t1), g = inner(t, t2), h = inner(t, t3);
  facts.about([&] { return text(point) + " in the first three tensors of " + text(trial.field); });
  const Scalar minus_one = facts.claimed(-1), also_minus_one = facts.claimed(-1);
  facts.equal("w times the third equation and a combination of the others", w * (u * g - v * f),
              minus_one * u * (v * h - w * g) + also_minus_one * v * (w * f - u * h));
  // At w = 0 the two ask for h = 0 only. At (1, 0, 0) of diag(1, 0, -1), diag(1, -2, 1) and xy that
  // is so, and the third equation, g = 0, does not hold.
  const auto first = square(facts.tensor(Tensor{1, 0, -1, 0, 0, 0}));
  const Scalar at_g = inner(first, facts.tensor(Tensor{1, -2, 1, 0, 0, 0})),
               at_h = inner(first, facts.tensor(Tensor{0, 0, 0, 1, 0, 0}));
  facts.zero("h at w = 0", at_h);
  facts.equal("third equation at w = 0", at_g, facts.claimed(2));
};

void points_at_infinity(const Trial& trial, Facts<Rational>& facts) {
  Random random = trial.random;
  const Tensor extremum = tensor_of({2, -1, -1}, random_basis(random));
  const auto& d = trial.field.vertex;
  // The extremum in a direction of a plane, and at a point of it.
  const Rational x(random.integer(1, 4)), y(random.integer(1, 4)), z(random.integer(1, 4));
  const auto spanned = [&](const Rational& weight) {
    const auto third = Rational(Rational(1) / weight) * (deviator(extremum) - x * d[0] - y * d[1]);
    return TriangleField<Rational>{{d[0], d[1], third}};
  };
  const TriangleField<Rational> far = spanned(-(x + y)), near = spanned(z);
  const auto far_plane = plane_of(far), near_plane = plane_of(near);
  if (!far_plane || !near_plane) return facts.not_applicable("dependent tensors");
  const CriticalSystem system = critical_system(*far_plane);
  if (system.position != Position::general) return facts.not_applicable(words(system.position));
  static const int in_witness =
      at_infinity(critical_system(*plane_of(off_diagonal().face())).critical);
  // Every critical point of the trial's own plane: in the plane, and critical there, exactly if the
  // sum of its weights is not 0.
  if (const auto own = plane_of(trial.field)) {
    const CriticalSystem all = critical_system(*own);
    if (all.position == Position::general) {
      facts.about([&] { return "plane of " + text(trial.field); });
      facts.holds("derivatives in the plane vanish", is_critical_in_plane(*own, all.critical));
      facts.holds("points in the plane and at infinity",
                  in_plane(all.critical) + at_infinity(all.critical) == all.critical.count());
    }
  }
  facts.about([&] { return text(extremum) + " with " + text(trial.field); });
  for (const TriangleField<Rational>& field : {far, near}) {
    const Tensor first = to_tensor(field.vertex[1] - field.vertex[0]);
    const Tensor second = to_tensor(field.vertex[2] - field.vertex[0]);
    for (const Tensor& along : {first, second}) {
      facts.equal("derivative of the mode",
                  inner(extremum, extremum) * inner(square(extremum), along),
                  inner(square(extremum), extremum) * inner(extremum, along));
    }
  }
  facts.equal("the tensor at a point", to_tensor(near.at({x, y, z})), extremum);
  facts.holds("the tensor at infinity counted there", at_infinity(system.critical) >= 1);
  facts.holds("two saddles of the witness at infinity", in_witness == facts.claimed_count(2));
}

}  // namespace

Check check_spurious_solutions() { return spurious_solutions; }
Check check_redundancy() { return redundancy; }
Check check_points_at_infinity() { return points_at_infinity; }

Outcome fewer_than_nine_solutions() {
  const WitnessPlane& witness = off_diagonal_shifted();
  const TensorTriple basis = basis_from_maximum();
  const int degree = solutions_in_chart(basis);
  const bool lost = critical_minors(basis, basis[0]) == Vector3<Integer>{};
  if (degree == 9 || !lost || gradient_degree(basis) == 3) return Outcome::holds();
  return Outcome::violated(witness.name + ", Gram-Schmidt on T_0, T_x + 2 T_y, T_y: degree " +
                           std::to_string(degree) +
                           " with w = 1, f, g and h quadratic, and the maximum at the origin has "
                           "w = 0");
}

Outcome saddles_at_infinity() {
  const WitnessPlane& witness = off_diagonal();
  const Plane plane = *plane_of(witness.face());
  const CriticalCounts counts = count(real_points(plane, critical_system(plane).critical));
  if (counts.at_infinity == 0) return Outcome::holds();
  return Outcome::violated(witness.name + ": " + text(counts));
}

}  // namespace tensortopo::theory
