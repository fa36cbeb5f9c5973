// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/critical_points.hpp"

#include "plane/elimination.hpp"
#include "plane/real_zeros.hpp"
#include "tensortopo/theory/random.hpp"

namespace tensortopo::theory {
namespace {

// The columns of an invertible matrix: a basis in terms of another one.
using Change = std::array<Vector3<Integer>, 3>;

constexpr int kCharts = 24;

// Number `index` of some charts without any relation to a field. The entries are small, so that
// the resultants are; symmetric fields may need larger ones.
Change chart(int index) {
  Random random(static_cast<std::uint64_t>(index) + 1);
  const int bound = 1 + index / 4;
  while (true) {
    Change change;
    for (auto& column : change) {
      column = {Integer(random.integer(-bound, bound)), Integer(random.integer(-bound, bound)),
                Integer(random.integer(-bound, bound))};
    }
    if (dot(change[0], cross(change[1], change[2])) != 0) return change;
  }
}

// What has these coordinates in the changed basis, in the original one.
Vector3<Polynomial> original(const Change& change, const Vector3<Polynomial>& v) {
  return v.x * vector_cast<Polynomial>(change[0]) + v.y * vector_cast<Polynomial>(change[1]) +
         v.z * vector_cast<Polynomial>(change[2]);
}

std::array<IntegerTensor, 3> changed(const std::array<IntegerTensor, 3>& basis,
                                     const Change& change) {
  return {combined(basis, change[0]), combined(basis, change[1]), combined(basis, change[2])};
}

// The matrix of a quadratic form in the changed coordinates.
IntegerTensor changed(const IntegerTensor& form, const Change& change) {
  const auto entry = [&](std::size_t i, std::size_t j) { return dot(change[i], form * change[j]); };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(0, 2)};
}

}  // namespace

Vector3<Polynomial> primitive(const Vector3<Polynomial>& v) {
  const Integer common = gcd(gcd(content(v.x), content(v.y)), content(v.z));
  if (common == 0) return v;
  return {exact_quotient(v.x, common), exact_quotient(v.y, common), exact_quotient(v.z, common)};
}

std::string words(Position position) {
  switch (position) {
    case Position::not_isolated:
      return "a curve of critical points";
    case Position::coincident:
      return "critical points coincide in every chart tried";
    case Position::isotropic:
      return "a complex tensor of square zero is orthogonal to the plane and belongs to a zero";
    case Position::general:
      break;
  }
  return "general position";
}

CriticalSystem critical_system(const Plane& plane) {
  CriticalSystem system;
  for (int i = 0; i < kCharts; ++i) {
    const Change change = chart(i);
    const Elimination e = eliminate(changed(plane.basis, change));
    if (!e.proper || e.spurious.is_zero()) continue;
    if (e.all.is_zero()) {
      // The two cubics share a factor. It is not p_3, for f_3 is not zero along that line; and off
      // the line the third cubic vanishes with the two.
      system.position = Position::not_isolated;
      return system;
    }
    if (e.all.degree() != 9 || !is_squarefree(e.all)) continue;
    const Polynomial spurious = greatest_common_divisor(e.all, e.spurious);
    system.position = Position::general;
    system.solutions = e.all.degree();
    system.spurious = spurious.degree();
    system.critical = {quotient(e.all, spurious), primitive(original(change, e.solution))};
    return system;
  }
  return system;
}

DegenerateSystem degenerate_system(const Plane& plane) {
  DegenerateSystem system;
  for (int i = 0; i < kCharts; ++i) {
    const Change change = chart(i);
    const Conics conics =
        eliminate(changed(plane.complement[0], change), changed(plane.complement[1], change));
    if (!conics.proper) continue;
    if (conics.all.is_zero()) {
      system.position = Position::not_isolated;
      return system;
    }
    if (conics.all.degree() != 4 || !is_squarefree(conics.all)) continue;
    const Vector3<Polynomial> e = original(change, conics.solution);
    const SymmetricTensor<Polynomial> projection = {e.x * e.x, e.y * e.y, e.z * e.z,
                                                    e.x * e.y, e.y * e.z, e.x * e.z};
    system.position = Position::general;
    system.points = {conics.all, primitive(coordinates(plane, projection))};
    return system;
  }
  return system;
}

std::vector<CriticalKind> real_points(const Plane& plane, const PointFamily& family) {
  if (family.count() <= 0) return {};
  const RealZeros zeros(family.parameters);
  const auto tensor = family.tensor(plane);
  const auto morse = zeros.signs(morse_form(plane.basis, tensor));
  const auto degeneracy = zeros.signs(degeneracy_form(tensor));
  const auto sum = zeros.signs(family.weight_sum());
  std::vector<CriticalKind> points;
  for (std::size_t i = 0; i < zeros.count(); ++i) {
    points.push_back({morse[i], degeneracy[i], sum[i]});
  }
  return points;
}

CriticalCounts count(const std::vector<CriticalKind>& points) {
  CriticalCounts counts;
  for (const CriticalKind& point : points) {
    const bool extremum = point.morse == Sign::positive;
    const bool degenerate = point.degeneracy == Sign::zero;
    counts.extrema += extremum;
    counts.saddles += point.morse == Sign::negative;
    counts.singular += point.morse == Sign::zero;
    counts.degenerate += degenerate;
    counts.nondegenerate_extrema += extremum && !degenerate;
    counts.at_infinity += point.weight_sum == Sign::zero;
  }
  return counts;
}

std::string text(const CriticalCounts& c) {
  return std::to_string(c.extrema) + " extrema, " + std::to_string(c.saddles) + " saddles, " +
         std::to_string(c.degenerate) + " degenerate points, " + std::to_string(c.at_infinity) +
         " at infinity";
}

}  // namespace tensortopo::theory
