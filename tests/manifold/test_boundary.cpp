// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "../field/witness.hpp"
#include "manifold_case.hpp"
#include "support/compared.hpp"
#include "tensortopo/scalar/constants.hpp"

namespace tensortopo {
namespace {

using Manifold = MediumEigenvectorManifold<Real50>;

Manifold manifold_of(const witness::Field& f, const char* mode) {
  return {*characteristic_tensor(witness::unit_tetrahedron<Real50>(f)),
          mode_parameter<Real50>(ModeValue::parse(mode))};
}

TEST(ComplexDomainBoundary, HasOneLoopAboveTheBifurcationAndTwoBelow) {
  // saddle_origin_rational bifurcates at 143/343 = 0.41690962..., saddle_origin at 0.53994924...
  EXPECT_EQ(manifold_of(witness::saddle_origin_rational, "0.4169").loop_count(), 2);
  EXPECT_EQ(manifold_of(witness::saddle_origin_rational, "0.4170").loop_count(), 1);
  EXPECT_EQ(manifold_of(witness::saddle_origin, "0.5399492").loop_count(), 2);
  EXPECT_EQ(manifold_of(witness::saddle_origin, "-0.5399493").loop_count(), 1);
  const Manifold critical = manifold_of(witness::saddle_origin_rational, "143/343");
  EXPECT_LT(abs(Real50(critical.c() - critical.p())), Real50("1e-48"));
}

TEST(ComplexDomainBoundary, BifurcatesWhereTheSquaresOfTheModesSumToOne) {
  // c = p gives s0 = (b1 - b2) / (b1 + b2), for every characteristic tensor.
  for (const auto& f : witness::full_rank) {
    const auto t = characteristic_tensor(witness::unit_tetrahedron<Real50>(f));
    const auto& b = t->eigenvalues;
    const Real50 s0 = (b[0] - b[1]) / (b[0] + b[1]);
    const auto mode = mode_parameter_from_s(s0, 1);
    EXPECT_LT(abs(Real50(mode.mu_squared + t->mode * t->mode - 1)), tiny()) << f.name;
  }
}

TEST(ComplexDomainBoundary, ParameterizationIsOnItClosedAndRegular) {
  test::Compared compared("boundary curves", 10);
  const Real50 turn = 2 * pi<Real50>(), h("1e-10");
  for (const auto& f : witness::full_rank)
    for (const char* text : {"1e-9", "0.1", "0.4", "0.6", "0.9", "0.9998", "1"}) {
      const Manifold m = manifold_of(f, text);
      if (m.complex_domain_empty()) continue;
      for (int loop = 0; loop < m.loop_count(); ++loop) {
        ++compared;
        EXPECT_LT(norm(m.boundary_point(loop, 0) - m.boundary_point(loop, turn)), tiny());
        for (int i = 0; i < 40; ++i) {
          const Real50 phi = turn * i / 40;
          const auto v = m.boundary_point(loop, phi);
          EXPECT_LT(abs(Real50(norm(v) - 1)), tiny());
          EXPECT_LT(abs(m.boundary_function(v)), tiny()) << f.name << ' ' << text << ' ' << i;
          const auto speed = m.boundary_point(loop, phi + h) - v;
          EXPECT_GT(norm(speed), Real50("1e-10") * h) << f.name << ' ' << text << ' ' << i;
        }
      }
    }
}

RC_GTEST_PROP(ComplexDomainBoundary, PositionInvertsTheParameterization, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  RC_PRE(!m.complex_domain_empty());
  const int loop = *rc::gen::inRange(0, m.loop_count());
  const Real50 turn = 2 * pi<Real50>();
  const Real50 phi = turn * *rc::gen::inRange(0, 10000) / 10000;
  const auto v = m.boundary_point(loop, phi);
  for (const int sign : {1, -1}) {
    const auto at = m.boundary_position(sign > 0 ? v : -v);
    RC_ASSERT(at.loop == loop);
    RC_ASSERT(at.sign == sign);
    const Real50 difference = abs(Real50(at.phi - phi));
    RC_ASSERT(difference < Real50("1e-20") || abs(Real50(difference - turn)) < Real50("1e-20"));
    RC_ASSERT(norm(m.boundary_point(at.loop, at.phi) - v) < Real50("1e-20"));
  }
}

RC_GTEST_PROP(ComplexDomainBoundary, AntipodesShareOneTensorThere, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  RC_PRE(!m.complex_domain_empty());
  const Real50 phi = Real50(*rc::gen::inRange(0, 62832)) / 10000;
  const auto v = m.boundary_point(*rc::gen::inRange(0, m.loop_count()), phi);
  const auto t = m.tensor_at_boundary(v);
  const Real50 one(1);
  RC_ASSERT(norm(t - m.tensor_at_boundary(-v)) < tiny());
  RC_ASSERT(abs(Real50(norm(t) - one)) < tiny());
  RC_ASSERT(abs(inner(t, c.characteristic->tensor)) < tiny());
  RC_ASSERT(abs(Real50(mode(deviator(t)) - c.mode.abs_mu)) < tiny());
  RC_ASSERT(norm(t * v - c.mode.eigenvalues[1] * v) < tiny());
  // Half of the digits remain when the tensor goes through the root at the boundary.
  RC_ASSERT(norm(t - m.tensor_at(v)) < Real50("1e-18"));
  RC_ASSERT(abs(m.sigma(v, m.dominant_eigenvector(v))) < Real50("1e-18"));
  // t ~ P T P + (alpha/2)(1 + s^2/3) P - (s^2/3) alpha v v^T, with a negative factor.
  const auto& tb = c.characteristic->tensor;
  const Real50 alpha = dot(v, tb * v), s2 = c.mode.s_squared;
  for (const auto& x :
       {Vector3<Real50>{1, 0, 0}, Vector3<Real50>{0, 1, 0}, Vector3<Real50>{0, 0, 1}}) {
    const auto px = x - dot(v, x) * v;
    const auto tpx = tb * px;
    const auto expected = tpx - dot(v, tpx) * v + Real50(alpha / 2 * (1 + s2 / 3)) * px -
                          Real50(s2 / 3 * alpha * dot(v, x)) * v;
    RC_ASSERT(norm(cross(t * x, expected)) < tiny());
    RC_ASSERT(dot(t * x, expected) < tiny());
  }
}

RC_GTEST_PROP(ComplexDomain, GrowsWithTheMode, ()) {
  const auto t = characteristic_tensor(random_integer_field());
  RC_PRE(t.has_value());
  const int low = *rc::gen::inRange(0, 1000), high = *rc::gen::inRange(low, 1001);
  const auto at = [&](int thousandths) {
    return Manifold(
        *t, mode_parameter<Real50>(ModeValue::parse(std::to_string(thousandths) + "/1000")));
  };
  const auto v = random_unit_vector();
  RC_ASSERT(at(high).boundary_function(v) <= at(low).boundary_function(v) + tiny());
  // The singularities are inside for every mode but zero.
  RC_PRE(low > 0 && t->eigenvalues[1] > tiny());
  RC_ASSERT(!at(low).in_real_domain(at(low).singularities()[0]));
}

TEST(ComplexDomain, IsEmptyForTheNeutralModeAndForANeutralCharacteristicTensor) {
  EXPECT_TRUE(manifold_of(witness::generic_1, "0").complex_domain_empty());
  EXPECT_FALSE(manifold_of(witness::generic_1, "1e-9").complex_domain_empty());
  const Manifold neutral = manifold_of(witness::mubar_0, "0.9");
  EXPECT_TRUE(neutral.complex_domain_empty());
}

TEST(ComplexDomain, OfADegenerateCharacteristicTensorIsBoundedByACircle) {
  const Manifold m = manifold_of(witness::mubar_minus1, "0.2");
  EXPECT_TRUE(m.single_loop());
  const auto& axis = m.characteristic().eigenvectors[2];
  const Real50 height = dot(axis, m.boundary_point(0, Real50(0)));
  for (int i = 1; i < 8; ++i)
    EXPECT_LT(abs(Real50(dot(axis, m.boundary_point(0, Real50(i))) - height)), tiny());
}

}  // namespace
}  // namespace tensortopo
