// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "plane/pencil.hpp"
#include "plane/witness_planes.hpp"
#include "support/fields/witness_fields.hpp"
#include "tensortopo/field/planar_critical_points.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "tensortopo/theory/trial.hpp"

namespace tensortopo::theory {
namespace {

TriangleField<Rational> exact_face(const std::array<SymmetricTensor<double>, 3>& corners) {
  TriangleField<Rational> field;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& t = corners[i];
    field.vertex[i] = deviator(tensor_cast<Rational>(t));
  }
  return field;
}

Plane witness(const std::string& name) {
  return *plane_of(exact_face(test::planar_witness(name).corners()));
}

CriticalCounts counts_from_equations(const Plane& plane) {
  return count(real_points(plane, critical_system(plane).critical));
}

// The same from the complement: degenerate points, and those of the pencil.
CriticalCounts counts_from_complement(const Plane& plane) {
  const PencilSystem pencil = pencil_system(plane);
  std::vector<CriticalKind> all = real_points(plane, degenerate_system(plane).points);
  for (const PointFamily& family : {pencil.regular, pencil.neutral}) {
    const auto more = real_points(plane, family);
    all.insert(all.end(), more.begin(), more.end());
  }
  return count(all);
}

struct Golden {
  std::string name;
  CriticalCounts counts;  // extrema, saddles, singular; degenerate, smooth extrema, at infinity
};

// What the closed forms of these planes' modes say: see the notes of the witnesses.
const std::vector<Golden> kGolden = {
    {"offdiag", {4, 3, 0, 4, 0, 2}},
    {"offdiag_shifted", {4, 3, 0, 4, 0, 2}},
    {"ring_threefold_weak", {4, 3, 0, 4, 0, 0}},
    {"ring_threefold", {4, 3, 0, 4, 0, 0}},
    {"ring_onefold_weak", {2, 1, 0, 2, 0, 0}},
    {"ring_onefold", {2, 1, 0, 2, 0, 0}},
    {"three_extrema", {3, 2, 0, 2, 1, 0}},
};

TEST(PlanarCriticalPoints, AreThoseOfTheWitnesses) {
  for (const auto& [name, counts] : kGolden) {
    const Plane plane = witness(name);
    ASSERT_EQ(critical_system(plane).position, Position::general) << name;
    EXPECT_EQ(counts_from_equations(plane), counts) << name << text(counts_from_equations(plane));
    EXPECT_EQ(counts_from_complement(plane), counts) << name;
  }
}

TEST(PlanarCriticalPoints, FillACurveInAPlaneOfSymmetry) {
  const Plane plane = witness("ring");
  EXPECT_EQ(critical_system(plane).position, Position::not_isolated);
  EXPECT_EQ(degenerate_system(plane).position, Position::not_isolated);
  EXPECT_EQ(pencil_system(plane).position, Position::not_isolated);
}

TEST(PlanarCriticalPoints, NeedIndependentTensors) {
  TriangleField<Rational> field = off_diagonal().face();
  field.vertex[2] = field.vertex[0] + field.vertex[1];
  EXPECT_FALSE(plane_of(field));
}

TEST(PlanarCriticalPoints, AreNeutralWhereNormalsAreDegenerate) {
  const PencilSystem pencil = pencil_system(witness("offdiag"));
  EXPECT_EQ(pencil.regular.count(), 0);
  EXPECT_EQ(pencil.neutral.count(), 3);
  EXPECT_EQ(count(real_points(witness("offdiag"), pencil.neutral)).saddles, 3);
}

TEST(PlanarCriticalPoints, AreFoundWhereAComplexNormalIsIsotropic) {
  const PencilSystem pencil = pencil_system(witness("ring_onefold"));
  EXPECT_EQ(pencil.position, Position::isotropic);
  EXPECT_EQ(pencil.regular.count(), 1);
}

SymmetricTensor<Rational> integer_tensor(int bound) {
  const auto entry = [&] { return Rational(*rc::gen::inRange(-bound, bound + 1)); };
  return {entry(), entry(), entry(), entry(), entry(), entry()};
}

TriangleField<Rational> integer_face(int bound) {
  TriangleField<Rational> field;
  for (auto& d : field.vertex) d = deviator(integer_tensor(bound));
  return field;
}

// A plane in which all solutions are apart; discards the others.
Plane general_plane(const TriangleField<Rational>& field) {
  const auto plane = plane_of(field);
  RC_PRE(plane.has_value());
  RC_PRE(critical_system(*plane).position == Position::general);
  RC_PRE(degenerate_system(*plane).position == Position::general);
  RC_PRE(pencil_system(*plane).position == Position::general);
  return *plane;
}

RC_GTEST_PROP(PlanarCriticalPoints, AreTheSameBothWays, ()) {
  const Plane plane = general_plane(integer_face(*rc::gen::element(2, 5, 1000)));
  const CriticalCounts counts = counts_from_equations(plane);
  RC_LOG() << text(counts) << '\n';
  RC_ASSERT(counts == counts_from_complement(plane));
  RC_ASSERT(counts.extrema - counts.saddles == 1);
  RC_ASSERT(counts.degenerate == (neutral_normals(plane) == 3 ? 4 : 2));
}

SymmetricTensor<Rational> rotated(const SymmetricTensor<Rational>& t, const Basis& basis) {
  const auto entry = [&](std::size_t i, std::size_t j) { return dot(basis[i], t * basis[j]); };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(0, 2)};
}

RC_GTEST_PROP(PlanarCriticalPoints, DoNotChangeWhenThePlaneIsTurned, (std::uint64_t seed)) {
  TriangleField<Rational> field = integer_face(4);
  const CriticalCounts before = counts_from_equations(general_plane(field));
  Random random(seed);
  const Basis basis = random_basis(random);
  for (auto& d : field.vertex) d = deviator(rotated(to_tensor(d), basis));
  RC_ASSERT(counts_from_equations(general_plane(field)) == before);
}

RC_GTEST_PROP(PlanarCriticalPoints, DoNotChangeWithTheBasisExceptForThoseAtInfinity, ()) {
  const TriangleField<Rational> field = integer_face(4);
  CriticalCounts before = counts_from_equations(general_plane(field));
  TriangleField<Rational> changed;
  for (auto& d : changed.vertex) {
    for (const auto& from : field.vertex) d = d + Rational(*rc::gen::inRange(-3, 4)) * from;
  }
  CriticalCounts after = counts_from_equations(general_plane(changed));
  before.at_infinity = after.at_infinity = 0;
  RC_ASSERT(after == before);
}

template <class Count>
int count_of(const std::vector<PlanarCriticalPoint<double>>& points, const Count& has) {
  return static_cast<int>(std::count_if(points.begin(), points.end(), has));
}

void expect_found_by_library(const TriangleField<Rational>& exact, const std::string& name) {
  TriangleField<double> rounded;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& d = exact.vertex[k];
    const auto number = [](const Rational& x) { return x.convert_to<double>(); };
    rounded.vertex[k] = {number(d.a), number(d.b), number(d.xy), number(d.yz), number(d.xz)};
  }
  const CriticalCounts counts = counts_from_equations(*plane_of(exact));
  const auto others = nondegenerate_critical_points(rounded);
  const auto degenerate = degenerate_points(rounded);
  EXPECT_TRUE(degenerate.isolated) << name;
  EXPECT_EQ(static_cast<int>(degenerate.points.size()), counts.degenerate) << name;
  EXPECT_EQ(count_of(others, [](const auto& p) { return p.type == CriticalType::saddle; }),
            counts.saddles)
      << name;
  EXPECT_EQ(count_of(others, [](const auto& p) { return p.type == CriticalType::extremum; }),
            counts.nondegenerate_extrema)
      << name;
}

TEST(PlanarCriticalPoints, AreThoseThatTheLibraryFinds) {
  for (const Golden& golden : kGolden) {
    expect_found_by_library(exact_face(test::planar_witness(golden.name).corners()), golden.name);
  }
  int compared = 0;
  for (std::size_t i = 0; i < 150; ++i) {
    const TriangleField<Rational> exact = first_face(random_trial(11, i).field);
    const auto plane = plane_of(exact);
    if (!plane || critical_system(*plane).position != Position::general) continue;
    expect_found_by_library(exact, "field " + std::to_string(i));
    ++compared;
  }
  EXPECT_GE(compared, 140);
}

}  // namespace
}  // namespace tensortopo::theory
