// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "tensortopo/field/planar_critical_points.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {
namespace {

/// T0, T0 + Tx, T0 + Ty from entries in the order xx, xy, xz, yy, yz, zz with a common denominator.
template <class Scalar>
TriangleField<Scalar> plane(const int (&t)[3][6], int denominator = 1) {
  std::array<Deviator<Scalar>, 3> d;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto e = [&](std::size_t j) { return Scalar(Scalar(t[i][j]) / Scalar(denominator)); };
    d[i] = deviator(SymmetricTensor<Scalar>{e(0), e(3), e(5), e(1), e(4), e(2)});
  }
  return {{d[0], d[0] + d[1], d[0] + d[2]}};
}

/// 2 P dQ - 3 Q dP along a tensor: zero iff the derivative of the mode is. The derivative of the
/// cubic form comes from differences, which are exact for a cubic.
template <class Scalar>
Scalar mode_slope(const Deviator<Scalar>& t, const Deviator<Scalar>& x) {
  const Scalar dp = Scalar(2) * norm_form(t, x);
  const Scalar dq =
      (determinant_form(t + x) - determinant_form(t - x)) / Scalar(2) - determinant_form(x);
  return Scalar(2) * norm_form(t) * dq - Scalar(3) * determinant_form(t) * dp;
}

TriangleField<Real50> random_plane() {
  TriangleField<Real50> field;
  for (auto& d : field.vertex)
    for (Real50* x : {&d.a, &d.b, &d.xy, &d.yz, &d.xz}) *x = Real50(*rc::gen::inRange(-9, 10));
  return field;
}

RC_GTEST_PROP(PlanarCriticalPoints, AreWhereTheGradientOfTheModeVanishes, ()) {
  const auto field = random_plane();
  for (const auto& point : nondegenerate_critical_points(field)) {
    const auto t = Real50(1 / sqrt(norm_form(point.tensor))) * point.tensor;
    for (const auto& vertex : field.vertex) RC_ASSERT(abs(mode_slope(t, vertex)) < Real50("1e-40"));
    RC_ASSERT(abs(Real50(point.mode - mode(point.tensor))) < Real50("1e-45"));
    RC_ASSERT(point.weight_sum >= 0);
  }
}

RC_GTEST_PROP(PlanarCriticalPoints, OfAGenericPlaneSatisfyTheEulerNumber, ()) {
  const auto field = random_plane();
  const auto others = nondegenerate_critical_points(field);
  const auto degenerate = degenerate_points(field);
  RC_PRE(!others.empty() && degenerate.isolated);
  int extrema = static_cast<int>(degenerate.points.size()), saddles = 0;
  for (const auto& point : others) {
    RC_PRE(point.type != CriticalType::undecided);
    (point.type == CriticalType::extremum ? extrema : saddles) += 1;
  }
  // The projective plane has Euler number 1, and at least two of the extrema are degenerate points.
  RC_TAG(extrema, saddles);
  RC_ASSERT(extrema - saddles == 1);
  RC_ASSERT(degenerate.points.size() == 2u || degenerate.points.size() == 4u);
  RC_ASSERT(extrema >= 2 && extrema <= 4);
}

RC_GTEST_PROP(PlanarCriticalPoints, DegenerateOnesAreDegenerate, ()) {
  const auto field = random_plane();
  for (const auto& point : degenerate_points(field).points) {
    const auto t = Real50(1 / sqrt(norm_form(point.tensor))) * point.tensor;
    // Zeros may be double to rounding: half of the digits are promised, and a generic point keeps
    // most.
    RC_ASSERT(abs(lode_angle(t) - (point.mode > 0 ? Real50(0) : Real50(acos(Real50(-1)) / 3))) <
              Real50("1e-20"));
  }
}

template <class Scalar>
class PlanarWitness : public testing::Test {};
using Reals = testing::Types<double, Real50, Real100>;
TYPED_TEST_SUITE(PlanarWitness, Reals);

template <class Scalar>
bool is_at(const PlanarCriticalPoint<Scalar>& point, double x, double y) {
  const Scalar unit = Scalar(1) / Scalar(1 << 30) / Scalar(1 << 10);
  return abs(Scalar(point.weights[1] - Scalar(x) * point.weight_sum)) < unit &&
         abs(Scalar(point.weights[2] - Scalar(y) * point.weight_sum)) < unit;
}

constexpr int offdiag[3][6] = {{0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}};

TYPED_TEST(PlanarWitness, OffdiagHasFourDegenerateExtremaAndThreeSaddlesTwoOfThemAtInfinity) {
  using Scalar = TypeParam;
  const auto field = plane<Scalar>(offdiag);
  const auto saddles = nondegenerate_critical_points(field);
  ASSERT_EQ(saddles.size(), 3u);
  int at_infinity = 0, at_origin = 0;
  for (const auto& point : saddles) {
    EXPECT_EQ(point.type, CriticalType::saddle);
    EXPECT_LE(abs(point.mode), Scalar(64) * std::numeric_limits<Scalar>::epsilon());
    if (abs(point.weight_sum) <= Scalar(64) * std::numeric_limits<Scalar>::epsilon()) ++at_infinity;
    if (is_at(point, 0, 0) && point.weight_sum > Scalar(0.5)) ++at_origin;
  }
  EXPECT_EQ(at_infinity, 2);
  EXPECT_EQ(at_origin, 1);
  const auto degenerate = degenerate_points(field);
  EXPECT_TRUE(degenerate.isolated);
  ASSERT_EQ(degenerate.points.size(), 4u);
  for (const auto& [x, y, mode] : {std::array{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}})
    EXPECT_EQ(std::count_if(degenerate.points.begin(), degenerate.points.end(),
                            [&, x = x, y = y, mode = mode](const auto& point) {
                              return is_at(point, x, y) && point.mode == Scalar(mode);
                            }),
              1)
        << x << ' ' << y;
}

TYPED_TEST(PlanarWitness, ThreeExtremaHasItsInteriorMaximumAndTwoSaddles) {
  using Scalar = TypeParam;
  const auto field =
      plane<Scalar>({{-1, 0, 1, 2, 1, -1}, {0, 2, 1, 1, 0, -1}, {1, -1, 2, 0, 1, -1}});
  const auto points = nondegenerate_critical_points(field);
  ASSERT_EQ(points.size(), 3u);
  int found = 0;
  for (const auto& point : points) {
    const double m = static_cast<double>(point.mode);
    if (is_at(point, 0.1259440775081444, -0.3861687766788142)) {
      EXPECT_EQ(point.type, CriticalType::extremum);
      EXPECT_NEAR(m, 0.8477197816983983, 1e-14);
      ++found;
    } else if (is_at(point, -8.017202251294071, 6.224345050203285)) {
      EXPECT_EQ(point.type, CriticalType::saddle);
      EXPECT_NEAR(m, -0.39044225964418305, 1e-14);
      ++found;
    } else if (is_at(point, -2.8318853013402445, -0.8951337356729927)) {
      EXPECT_EQ(point.type, CriticalType::saddle);
      EXPECT_NEAR(m, -0.415906599019654, 1e-14);
      ++found;
    }
  }
  EXPECT_EQ(found, 3);
  const auto degenerate = degenerate_points(field).points;
  ASSERT_EQ(degenerate.size(), 2u);
  for (const auto& point : degenerate) {
    EXPECT_EQ(point.mode, Scalar(-1));
    EXPECT_TRUE(is_at(point, -0.14090819612840755, 1.3991737578206975) ||
                is_at(point, -0.5749414529468352, -1.0486793523733526));
  }
}

TYPED_TEST(PlanarWitness, RingIsASymmetryPlaneWithAnIsolatedCentreAndAConic) {
  using Scalar = TypeParam;
  const auto field = plane<Scalar>({{1, 0, 0, 1, 0, -2}, {1, 0, 0, -1, 0, 0}, {0, 1, 0, 0, 0, 0}});
  EXPECT_TRUE(nondegenerate_critical_points(field).empty());
  const auto degenerate = degenerate_points(field);
  EXPECT_FALSE(degenerate.isolated);
  ASSERT_EQ(degenerate.points.size(), 1u);
  EXPECT_TRUE(is_at(degenerate.points[0], 0, 0));
  EXPECT_EQ(degenerate.points[0].mode, Scalar(-1));
}

TYPED_TEST(PlanarWitness, PerturbedRingHasFourIsolatedExtremaAndThreeSaddles) {
  using Scalar = TypeParam;
  const auto field =
      plane<Scalar>({{10, 0, 0, 10, 0, -20}, {10, 0, 1, -10, 0, 0}, {0, 10, 0, 0, -1, 0}}, 10);
  const auto saddles = nondegenerate_critical_points(field);
  ASSERT_EQ(saddles.size(), 3u);
  int on_axis = 0;
  for (const auto& point : saddles) {
    EXPECT_EQ(point.type, CriticalType::saddle);
    EXPECT_NEAR(static_cast<double>(point.mode), 0.9666877288012319, 1e-13);
    if (is_at(point, -300.0 / 101, 0)) ++on_axis;
  }
  EXPECT_EQ(on_axis, 1);
  const auto degenerate = degenerate_points(field);
  EXPECT_TRUE(degenerate.isolated);
  ASSERT_EQ(degenerate.points.size(), 4u);
  EXPECT_EQ(std::count_if(degenerate.points.begin(), degenerate.points.end(),
                          [](const auto& p) { return is_at(p, 600.0 / 199, 0); }),
            1);
}

TYPED_TEST(PlanarWitness, DependentTensorsGiveNothing) {
  using Scalar = TypeParam;
  const auto field = plane<Scalar>({{1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5, 6}, {0, 1, 0, 0, 0, 0}});
  EXPECT_TRUE(nondegenerate_critical_points(field).empty());
  EXPECT_TRUE(degenerate_points(field).points.empty());
}

}  // namespace
}  // namespace tensortopo
