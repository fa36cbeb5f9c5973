// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {
namespace {

using Integers = std::array<int, 5>;

Integers small_integers() {
  Integers c{};
  for (int& x : c) x = *rc::gen::inRange(-50, 51);
  return c;
}

template <class Scalar>
Deviator<Scalar> deviator_of(const Integers& c) {
  return {Scalar(c[0]), Scalar(c[1]), Scalar(c[2]), Scalar(c[3]), Scalar(c[4])};
}

RC_GTEST_PROP(Discriminant, SatisfiesItsIdentityExactly, ()) {
  const auto d = deviator_of<Rational>(small_integers());
  const Rational p = norm_form(d), q = determinant_form(d);
  RC_ASSERT(p * p * p - Rational(2) * q * q == Rational(54) * discriminant_form(d));
}

RC_GTEST_PROP(Discriminant, VanishesExactlyOnDegenerateTensors, ()) {
  Integers e{};
  for (int& x : e) x = *rc::gen::inRange(-20, 21);
  const Rational x(e[0]), y(e[1]), z(e[2]), k(e[3]);
  const SymmetricTensor<Rational> t = {k * x * x, k * y * y, k * z * z,
                                       k * x * y, k * y * z, k * x * z};
  RC_ASSERT(discriminant_form(deviator(t)) == 0);
}

TEST(Discriminant, OfADiagonalTensorIsTheProductOfSquaredDifferences) {
  const SymmetricTensor<Rational> t = {11, 2, -13, 0, 0, 0};
  EXPECT_EQ(discriminant_form(deviator(t)), Rational(9 * 9 * 15 * 15 * 24 * 24));
}

RC_GTEST_PROP(Discriminant, EnclosureContainsTheExactValue, ()) {
  const Integers c = small_integers();
  Deviator<Interval> di = deviator_of<Interval>(c);
  Deviator<Rational> dr = deviator_of<Rational>(c);
  const Interval third = Interval(1) / Interval(3);
  di = third * di;
  dr = Rational(Rational(1) / Rational(3)) * dr;
  const Interval set = discriminant_form(di);
  RC_ASSERT(Rational(set.inf()) <= discriminant_form(dr));
  RC_ASSERT(discriminant_form(dr) <= Rational(set.sup()));
}

template <class Scalar>
class ModeTest : public testing::Test {
 protected:
  static Scalar ulps(int count) { return Scalar(count) * std::numeric_limits<Scalar>::epsilon(); }
};
using Reals = testing::Types<double, Real50, Real100>;
TYPED_TEST_SUITE(ModeTest, Reals);

TYPED_TEST(ModeTest, OfTheRationalTensorIsItsRationalValue) {
  using Scalar = TypeParam;
  const Deviator<Scalar> d = deviator(SymmetricTensor<Scalar>{11, 2, -13, 0, 0, 0});
  EXPECT_LE(abs(Scalar(mode(d) + Scalar(143) / Scalar(343))), this->ulps(4));
  EXPECT_LE(abs(Scalar(cos(Scalar(3) * lode_angle(d)) + Scalar(143) / Scalar(343))), this->ulps(4));
}

TYPED_TEST(ModeTest, AgreesWithTheEigenvalues) {
  using Scalar = TypeParam;
  rc::detail::checkGTest([] {
    const auto d = deviator_of<Scalar>(small_integers());
    RC_PRE(!(d == Deviator<Scalar>{}));
    const auto [l, vectors] = eigen_decomposition(to_tensor(d));
    const Scalar size = sqrt(Scalar(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]));
    const Scalar expected = Scalar(3) * sqrt(Scalar(6)) * l[0] * l[1] * l[2] / (size * size * size);
    RC_ASSERT(abs(Scalar(mode(d) - expected)) <=
              Scalar(64) * std::numeric_limits<Scalar>::epsilon());
  });
}

TYPED_TEST(ModeTest, StaysWithinOneOnDegenerateTensors) {
  using Scalar = TypeParam;
  rc::detail::checkGTest([] {
    Integers e{};
    for (int& x : e) x = *rc::gen::inRange(-1000, 1001);
    const Scalar x(e[0]), y(e[1]), z(e[2]);
    const Scalar third = Scalar(1) / Scalar(7);
    const auto d =
        third * deviator(SymmetricTensor<Scalar>{x * x, y * y, z * z, x * y, y * z, x * z});
    RC_PRE(!(d == Deviator<Scalar>{}));
    RC_ASSERT(mode(d) <= Scalar(1));
    RC_ASSERT(lode_angle(d) <= Scalar(16) * std::numeric_limits<Scalar>::epsilon());
    RC_ASSERT(mode(Scalar(-1) * d) >= Scalar(-1));
  });
}

TYPED_TEST(ModeTest, LodeAngleIsOneLipschitz) {
  using Scalar = TypeParam;
  rc::detail::checkGTest([] {
    const auto s = deviator_of<Scalar>(small_integers());
    const auto step = deviator_of<Scalar>(small_integers());
    const Scalar scale = Scalar(1) / Scalar(*rc::gen::element(1, 10, 1000, 1000000));
    const auto t = s + scale * step;
    RC_PRE(!(s == Deviator<Scalar>{}) && !(t == Deviator<Scalar>{}));
    const Scalar change = abs(Scalar(lode_angle(s) - lode_angle(t)));
    RC_ASSERT(change <= angle_between(s, t) + Scalar(32) * std::numeric_limits<Scalar>::epsilon());
  });
}

TYPED_TEST(ModeTest, LodeAnglesOfASimplexStayWithinTheReachOfEachVertex) {
  using Scalar = TypeParam;
  // Vertex tensors within an angle r < pi/2 of the first one lie in a convex ball around it.
  rc::detail::checkGTest([] {
    const auto first = deviator_of<Scalar>(small_integers());
    RC_PRE(!(first == Deviator<Scalar>{}));
    Deviator<Scalar> inside = first;
    Scalar reach(0);
    for (int i = 0; i < 3; ++i) {
      const auto vertex = Scalar(8) * first + deviator_of<Scalar>(small_integers());
      RC_PRE(!(vertex == Deviator<Scalar>{}));
      const Scalar r = angle_between(first, vertex);
      if (r > reach) reach = r;
      inside = inside + Scalar(*rc::gen::inRange(0, 100)) * vertex;
    }
    RC_PRE(reach < Scalar(1.5));
    const Scalar rounding = Scalar(32) * std::numeric_limits<Scalar>::epsilon();
    RC_ASSERT(abs(Scalar(lode_angle(inside) - lode_angle(first))) <= reach + rounding);
  });
}

TYPED_TEST(ModeTest, OrthonormalCoordinatesKeepTheInnerProduct) {
  using Scalar = TypeParam;
  rc::detail::checkGTest([] {
    const auto s = deviator_of<Scalar>(small_integers()), t = deviator_of<Scalar>(small_integers());
    const auto x = orthonormal_coordinates(s), y = orthonormal_coordinates(t);
    Scalar sum(0);
    for (std::size_t i = 0; i < 5; ++i) sum = sum + x[i] * y[i];
    const Scalar unit =
        std::numeric_limits<Scalar>::epsilon() * (Scalar(1) + norm_form(s) + norm_form(t));
    RC_ASSERT(abs(Scalar(sum - inner(to_tensor(s), to_tensor(t)))) <= Scalar(8) * unit);
    const auto back = from_orthonormal_coordinates(x) - s;
    RC_ASSERT(norm_form(back) <= Scalar(64) * unit * unit);
  });
}

TEST(Mode, LodeAngleTellsTensorsApartWhereTheModeCannot) {
  // diag(2, -1 + d, -1 - d): eigenvalue gap 2 d, Lode angle d / sqrt(3) to first order.
  for (const double d : {1e-9, 1e-12, 1e-100}) {
    const Deviator<double> t = {3, 0, 0, d, 0};
    EXPECT_EQ(mode(t), 1);
    EXPECT_NEAR(lode_angle(t) / (d / std::sqrt(3.0)), 1, 1e-14);
  }
}

TEST(Mode, IsTheSameAtEveryScale) {
  const Deviator<double> d = {3, -1, 2, 5, -4};
  const double expected = mode(d), angle = lode_angle(d);
  for (const double scale : {0x1p-1060, 0x1p-500, 0x1p500, 0x1p1018}) {
    EXPECT_EQ(mode(scale * d), expected) << scale;
    EXPECT_EQ(lode_angle(scale * d), angle) << scale;
  }
}

TEST(Mode, OfTheZeroDeviatorIsNothingNotNeutral) {
  EXPECT_FALSE(mode_if_defined(Deviator<double>{}).has_value());
  EXPECT_EQ(mode_if_defined(Deviator<double>{0, 0, 1, 0, 0}).value(), 0);
}

RC_GTEST_PROP(Mode, IsOddAndBlindToTheTraceAndToPositiveScaling, ()) {
  const auto d = deviator_of<double>(small_integers());
  RC_PRE(!(d == Deviator<double>{}));
  RC_ASSERT(mode(-1.0 * d) == -mode(d));
  RC_ASSERT(mode(4.0 * d) == mode(d));
  const SymmetricTensor<double> t = {1.0 * d.a + 7, 7, 7 - d.b, d.xy, d.yz, d.xz};
  RC_ASSERT(deviator(t) == d);
}

}  // namespace
}  // namespace tensortopo
