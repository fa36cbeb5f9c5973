// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "../field/witness.hpp"
#include "manifold_case.hpp"
#include "tensortopo/manifold/field_lift.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"

namespace tensortopo {
namespace {

RC_GTEST_PROP(FieldLift, RecoversTheWeightsOfFieldTensors, ()) {
  const auto field = random_integer_field();
  RC_PRE(characteristic_tensor(field).has_value());
  std::array<Real50, 4> b;
  for (auto& x : b) x = Real50(*rc::gen::inRange(-99, 100)) / 7;
  const auto w = FieldLift<Real50>(field).weights(field.at(b));
  for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(abs(Real50(w[i] - b[i])) < tiny());
}

RC_GTEST_PROP(FieldLift, TakesThePointOfTheManifoldBackToSpace, ()) {
  // A point of the tetrahedron, its tensor, that tensor's mode and canonical medium eigenvector:
  // the manifold of that mode returns the tensor, and the lift the point.
  const auto field = random_integer_field();
  const auto characteristic = characteristic_tensor(field);
  RC_PRE(characteristic.has_value());
  std::array<Real50, 4> b;
  Real50 sum = 0;
  for (auto& x : b) sum += (x = Real50(*rc::gen::inRange(1, 100)));
  for (auto& x : b) x /= sum;
  const auto t = field.at(b);
  const Real50 m = mode(t);
  RC_PRE(abs(m) > Real50("0.01") && abs(m) < Real50("0.999"));
  const auto [l, e] = eigen_decomposition(to_tensor(t));
  const int sign = m > 0 ? 1 : -1;
  const auto parameter = mode_parameter_from_s<Real50>(abs(3 * l[1] / (l[0] - l[2])), sign);
  RC_ASSERT(abs(Real50(parameter.mu - m)) < tiny());
  const MediumEigenvectorManifold<Real50> manifold(*characteristic, parameter);
  const auto& dominant = sign > 0 ? e[0] : e[2];
  const Real50 sigma = manifold.sigma(e[1], dominant);
  RC_PRE(abs(sigma) > Real50("1e-6"));
  const auto v = sigma > 0 ? -e[1] : e[1];
  RC_ASSERT(manifold.in_real_domain(v));
  const auto w = FieldLift<Real50>(field).weights(manifold.tensor_at(v));
  const Real50 c = w[0] + w[1] + w[2] + w[3];
  RC_ASSERT((c > 0) == (sign > 0));
  for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(abs(Real50(w[i] / c - b[i])) < Real50("1e-30"));
  RC_ASSERT(abs(Real50(mode(field.at({w[0] / c, w[1] / c, w[2] / c, w[3] / c})) - m)) < tiny());
}

TEST(FieldLift, DropsWhatIsAcrossTheField) {
  const auto field = witness::unit_tetrahedron<double>(witness::generic_1);
  const auto across = characteristic_tensor(field)->tensor;
  for (const double w : FieldLift<double>(field).weights(across)) EXPECT_NEAR(w, 0, 1e-14);
}

TEST(FieldLift, RefusesAFieldWithAZeroVertex) {
  auto field = witness::unit_tetrahedron<double>(witness::generic_1);
  field.vertex[2] = {};
  EXPECT_THROW(FieldLift<double>{field}, std::invalid_argument);
}

TEST(FieldLift, PutsTheBoundedBoundaryLoopOfTheWitnessIntoItsKnownBox) {
  // A boundary loop of the complex domain that is bounded in space, at mode 1/2 (field C1_loop).
  const auto field = witness::unit_tetrahedron<double>(witness::c1_loop);
  const MediumEigenvectorManifold<double> m(*characteristic_tensor(field),
                                            mode_parameter<double>(ModeValue::parse("1/2")));
  const FieldLift<double> lift(field);
  ASSERT_EQ(m.loop_count(), 2);
  int bounded = 0;
  for (int loop = 0; loop < 2; ++loop) {
    double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
    int positive = 0;
    constexpr int samples = 4000;
    for (int i = 0; i < samples; ++i) {
      const auto v = m.boundary_point(loop, 2 * 3.14159265358979 * i / samples);
      const auto w = lift.weights(m.tensor_at_boundary(v));
      const double c = w[0] + w[1] + w[2] + w[3];
      positive += c > 0;
      for (int k = 0; k < 3; ++k) {
        const double x = w[static_cast<std::size_t>(k + 1)] / c;
        low[k] = std::min(low[k], x);
        high[k] = std::max(high[k], x);
      }
    }
    if (positive != 0 && positive != samples) continue;
    ++bounded;
    const double expected_low[3] = {-0.69848, -3.5635, -2.0402};
    const double expected_high[3] = {0.76375, 3.5635, 2.0402};
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(low[k], expected_low[k], 1e-4);
      EXPECT_NEAR(high[k], expected_high[k], 1e-4);
    }
  }
  EXPECT_EQ(bounded, 1);
}

}  // namespace
}  // namespace tensortopo
