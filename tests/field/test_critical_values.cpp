// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/generators.hpp"
#include "support/fields/random_fields.hpp"
#include "support/fields/strata_fields.hpp"
#include "tensortopo/field/binary_cubic.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/field/critical_values.hpp"
#include "tensortopo/field/planar_critical_points.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

double size_of_mode(const Deviator<Real50>& t) { return std::abs(static_cast<double>(mode(t))); }

// Sizes of the critical values along the line of tensors through two.
void add_values_of_line(const Deviator<Real50>& a, const Deviator<Real50>& b,
                        std::vector<double>& values) {
  // P and Q of x a + y b, powers of x first; their Jacobian.
  const auto m = thrice(a), k = thrice(b);
  const Real50 p0 = norm_form(a), p1 = 2 * norm_form(a, b), p2 = norm_form(b);
  const Real50 q0 = determinant_form(a), q1 = inner(square(m), k), q2 = inner(square(k), m),
               q3 = determinant_form(b);
  const std::array<Real50, 4> jacobian{
      2 * p0 * q1 - 3 * p1 * q0, 4 * p0 * q2 - p1 * q1 - 6 * p2 * q0,
      6 * p0 * q3 + p1 * q2 - 4 * p2 * q1, 3 * p1 * q3 - 2 * p2 * q2};
  for (const auto& [x, y] : binary_cubic_zeros(jacobian))
    values.push_back(size_of_mode(x * a + y * b));
}

// Sizes of all critical values of the spans of the vertices, edges and faces, found otherwise; the
// one inside is that of the characteristic tensor.
std::vector<double> known_values(const TetTensors& tensors) {
  std::vector<double> values;
  std::array<Deviator<Real50>, 4> field;
  for (std::size_t i = 0; i < 4; ++i) field[i] = deviator(tensor_cast<Real50>(tensors[i]));
  for (std::size_t i = 0; i < 4; ++i) {
    values.push_back(size_of_mode(field[i]));
    for (std::size_t j = 0; j < i; ++j) add_values_of_line(field[i], field[j], values);
    const TriangleField<Real50> face{{field[(i + 1) % 4], field[(i + 2) % 4], field[(i + 3) % 4]}};
    for (const auto& point : nondegenerate_critical_points(face))
      values.push_back(size_of_mode(point.tensor));
  }
  const double n = size_of_mode(
      characteristic_direction(TetrahedronField<Real50>{{field[0], field[1], field[2], field[3]}}));
  values.push_back(std::sqrt(1 - n * n));
  return values;
}

ModeValue mode_of(double m) { return ModeValue::parse(std::to_string(m)); }

// As ranges without a known value are free, and the others are not, no value is missed and none is
// made up.
RC_GTEST_PROP(CriticalValues, AreThoseFoundOtherwise, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  TetTensors tensors = random.tet_tensors();
  for (auto& t : tensors) t = rounded(8.0 * t, 0);
  for (const auto& t : tensors) RC_PRE(norm_form(deviator(t)) > 0);
  const auto values = known_values(tensors);
  for (const auto own : {OwnLevel::excluded, OwnLevel::included}) {
    const double from = random.uniform(), to = from + random.uniform() * random.uniform();
    if (to >= 0.999) continue;
    const ModeValue mu = mode_of(from), other = mode_of(to);
    const double low = mu.approx(), high = other.approx();
    bool near_end = false, any = false;
    for (const double v : values) {
      near_end |= std::abs(v - low) < 1e-12 || std::abs(v - high) < 1e-12;
      any |= v > low && v < high;
    }
    if (near_end) continue;
    RC_ASSERT(is_free_of_critical_values(tensors, mu, other, own) == !any);
    RC_ASSERT(is_free_of_critical_values(tensors, other.opposite(), mu.opposite(), own) == !any);
  }
}

class SpecialValues : public testing::TestWithParam<Stratum> {
 protected:
  static bool on_some_edge(const TetTensors& t, const ModeValue& mu) {
    bool some = false;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) some |= is_critical_on_edge(t[i], t[j], mu);
    return some;
  }
  static bool on_some_plane(const TetTensors& t, const ModeValue& mu) {
    bool some = false;
    for (std::size_t i = 0; i < 4; ++i)
      some |= is_critical_on_plane({t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]}, mu);
    return some;
  }
};

// The value of a stratum is critical, by itself; next to it there is none.
TEST_P(SpecialValues, AreTold) {
  const std::string special = special_mode(GetParam());
  const ModeValue mu = ModeValue::parse(special);
  const ModeValue above = ModeValue::parse(special == "0"         ? "1/10000000000"
                                           : special == "4/5"     ? "0.8000000001"
                                           : special == "143/343" ? "0.4169096210"
                                                                  : "-0.4169096209");
  ASSERT_GT(above.approx(), mu.approx());
  for (std::uint64_t seed = 1; seed < 12; ++seed) {
    Random random(seed);
    const TetTensors tensors = stratum_tensors(GetParam(), random);
    EXPECT_TRUE(is_free_of_critical_values(tensors, mu, above, OwnLevel::excluded)) << seed;
    EXPECT_FALSE(is_free_of_critical_values(tensors, mu, above, OwnLevel::included)) << seed;
    EXPECT_FALSE(is_free_of_critical_values(tensors, above, mu, OwnLevel::excluded)) << seed;
    if (GetParam() == Stratum::tangent_edge) {
      EXPECT_TRUE(on_some_edge(tensors, mu)) << seed;
    }
    if (GetParam() == Stratum::face_saddle || GetParam() == Stratum::face_minimum ||
        GetParam() == Stratum::face_maximum) {
      EXPECT_TRUE(on_some_plane(tensors, mu)) << seed;
    }
    EXPECT_FALSE(on_some_edge(tensors, above)) << seed;
    EXPECT_FALSE(on_some_plane(tensors, above)) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Strata, SpecialValues,
                         testing::Values(Stratum::tangent_edge, Stratum::face_saddle,
                                         Stratum::face_minimum, Stratum::face_maximum,
                                         Stratum::tet_saddle, Stratum::vertex_on_level),
                         [](const auto& tested) { return name_of(tested.param); });

// The mode -4/5 of the opposite tensors is the least on their edge: the sign counts for edges.
TEST(CriticalValues, OnEdgesHaveASign) {
  const SymmetricTensor<double> first{0, 0, 0, 1, 2, 1}, second{0, 0, 0, 1, 2, 2};
  EXPECT_TRUE(is_critical_on_edge(first, second, ModeValue::parse("4/5")));
  EXPECT_FALSE(is_critical_on_edge(first, second, ModeValue::parse("-4/5")));
  EXPECT_TRUE(is_critical_on_edge(-1.0 * first, -1.0 * second, ModeValue::parse("-4/5")));
  // Beyond the maximum: no critical point between the ends.
  EXPECT_FALSE(is_critical_on_edge(second, second + (second - first), ModeValue::parse("4/5")));
}

}  // namespace
}  // namespace tensortopo::test
