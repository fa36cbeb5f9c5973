// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <type_traits>

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "witness.hpp"

namespace tensortopo {
namespace {

using Integers = std::array<std::array<int, 5>, 4>;

Integers random_field(int size) {
  Integers c{};
  for (auto& row : c)
    for (int& x : row) x = *rc::gen::inRange(-size, size + 1);
  return c;
}

template <class Scalar>
TetrahedronField<Scalar> field_of(const Integers& c) {
  TetrahedronField<Scalar> field;
  for (std::size_t i = 0; i < 4; ++i)
    field.vertex[i] = {Scalar(c[i][0]), Scalar(c[i][1]), Scalar(c[i][2]), Scalar(c[i][3]),
                       Scalar(c[i][4])};
  return field;
}

RC_GTEST_PROP(CharacteristicDirection, IsOrthogonalToTheFieldExactly, ()) {
  const auto field = field_of<Rational>(random_field(30));
  const auto direction = characteristic_direction(field);
  for (const auto& t : field.vertex) RC_ASSERT(norm_form(direction, t) == 0);
  RC_ASSERT(determinant_form(direction) <= 0);
}

RC_GTEST_PROP(CharacteristicDirection, VanishesExactlyBelowRankFour, ()) {
  const auto field = field_of<Rational>(random_field(1));
  const bool zero = characteristic_direction(field) == Deviator<Rational>{};
  RC_CLASSIFY(zero);
  RC_ASSERT(zero == (field_rank(field) < 4));
}

RC_GTEST_PROP(CharacteristicDirection, EnclosureContainsTheExactOneOrItsNegative, ()) {
  const auto c = random_field(30);
  const Interval seventh = Interval(1) / Interval(7);
  auto enclosed = field_of<Interval>(c);
  auto field = field_of<Rational>(c);
  for (auto& t : enclosed.vertex) t = seventh * t;
  for (auto& t : field.vertex) t = Rational(Rational(1) / Rational(7)) * t;
  const auto set = characteristic_direction(enclosed);
  const auto exact = characteristic_direction(field);
  const auto inside = [&](const Deviator<Rational>& d) {
    const auto in = [](const Interval& i, const Rational& x) {
      return Rational(i.inf()) <= x && x <= Rational(i.sup());
    };
    return in(set.a, d.a) && in(set.b, d.b) && in(set.xy, d.xy) && in(set.yz, d.yz) &&
           in(set.xz, d.xz);
  };
  RC_ASSERT(inside(exact) || inside(Rational(-1) * exact));
}

TEST(CharacteristicDirection, OfTheWitnessFieldsIsAsComputedByHand) {
  const auto parallel = [](const witness::Field& f, const SymmetricTensor<Rational>& expected) {
    const auto d = characteristic_direction(witness::unit_tetrahedron<Rational>(f));
    const auto e = deviator(expected);
    const Rational k = norm_form(d, e) / norm_form(e);
    EXPECT_EQ(d, k * e) << f.name;
    EXPECT_GT(k, 0) << f.name;
  };
  parallel(witness::saddle_origin, {2, 1, -3, 0, 0, 0});
  parallel(witness::saddle_origin_rational, {5, 3, -8, 0, 0, 0});
  parallel(witness::c1_loop, {2, 1, -3, 0, 0, 0});
  parallel(witness::mubar_minus1, {1, 1, -2, 0, 0, 0});
  parallel(witness::near_deficient, {2, 1, -3, 0, 0, 0});
  parallel(witness::generic_1, {70, -2, -68, 15, 60, -57});
}

template <class Scalar>
class CharacteristicTensorTest : public testing::Test {};
using Reals = testing::Types<double, Real50, Real100>;
TYPED_TEST_SUITE(CharacteristicTensorTest, Reals);

TYPED_TEST(CharacteristicTensorTest, IsUnitTracelessOrthogonalAndOfNegativeDeterminant) {
  using Scalar = TypeParam;
  rc::detail::checkGTest([] {
    const auto field = field_of<Scalar>(random_field(30));
    const auto t = characteristic_tensor(field);
    RC_PRE(t.has_value());
    const Scalar unit = Scalar(16) * std::numeric_limits<Scalar>::epsilon();
    RC_ASSERT(abs(trace(t->tensor)) <= unit);
    RC_ASSERT(abs(Scalar(inner(t->tensor, t->tensor) - Scalar(1))) <= unit);
    RC_ASSERT(determinant(t->tensor) <= unit);
    RC_ASSERT(t->eigenvalues[1] >= Scalar(0));
    RC_ASSERT(t->mode <= unit);
  });
}

TYPED_TEST(CharacteristicTensorTest, IsTheRoundedExactDirection) {
  using Scalar = TypeParam;
  rc::detail::checkGTest([] {
    const auto c = random_field(30);
    const auto t = characteristic_tensor(field_of<Scalar>(c));
    const auto exact = characteristic_direction(field_of<Rational>(c));
    RC_ASSERT(t.has_value() == !(exact == Deviator<Rational>{}));
    RC_PRE(t.has_value());
    // Neutral characteristic tensors satisfy the definition with both signs.
    RC_PRE(determinant_form(exact) != 0);
    // The normalised difference, in a scalar with more digits than any of those tested.
    using Wide = Real<150>;
    const auto wide = [](const Rational& x) {
      return Wide(Wide(boost::multiprecision::numerator(x).str()) /
                  Wide(boost::multiprecision::denominator(x).str()));
    };
    const Deviator<Wide> d = {wide(exact.a), wide(exact.b), wide(exact.xy), wide(exact.yz),
                              wide(exact.xz)};
    const Wide scale = sqrt(Wide(3) / norm_form(d));
    const auto mine = deviator(t->tensor);
    const Deviator<Wide> m = {Wide(mine.a), Wide(mine.b), Wide(mine.xy), Wide(mine.yz),
                              Wide(mine.xz)};
    // Elimination may lose what the smallest accepted pivot, 2^-20, amplifies.
    const Wide unit = Wide(std::numeric_limits<Scalar>::epsilon()) * Wide(1 << 22);
    RC_ASSERT(norm_form(m - scale * d) <= unit * unit);
  });
}

TYPED_TEST(CharacteristicTensorTest, ExistsExactlyForRankFour) {
  for (const auto& f : witness::all)
    EXPECT_EQ(characteristic_tensor(witness::unit_tetrahedron<TypeParam>(f)).has_value(),
              f.rank == 4)
        << f.name;
}

TYPED_TEST(CharacteristicTensorTest, HasTheModesOfTheWitnessFields) {
  using Scalar = TypeParam;
  const auto mode_squared = [](const witness::Field& f) {
    const auto t = characteristic_tensor(witness::unit_tetrahedron<Scalar>(f));
    return Scalar(t->mode * t->mode);
  };
  const Scalar unit = Scalar(32) * std::numeric_limits<Scalar>::epsilon();
  EXPECT_LE(abs(Scalar(mode_squared(witness::saddle_origin) - Scalar(243) / Scalar(343))), unit);
  EXPECT_LE(
      abs(Scalar(mode_squared(witness::saddle_origin_rational) - Scalar(97200) / Scalar(117649))),
      unit);
  EXPECT_LE(
      abs(Scalar(mode_squared(witness::generic_1) - Scalar(26127812881L) / Scalar(61442834536L))),
      unit);
  // Special values are recognised exactly.
  EXPECT_EQ(mode_squared(witness::mubar_0), Scalar(0));
  EXPECT_EQ(mode_squared(witness::mubar_minus1), Scalar(1));
  const auto b =
      characteristic_tensor(witness::unit_tetrahedron<Scalar>(witness::mubar_minus1))->eigenvalues;
  EXPECT_EQ(b[0], b[1]);
}

TEST(CharacteristicTensor, OfANearlyDeficientFieldKeepsItsDigits) {
  // The same doubles, solved in doubles and in a hundred digits.
  const auto coarse = witness::unit_tetrahedron<double>(witness::near_deficient);
  TetrahedronField<Real100> fine;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& d = coarse.vertex[i];
    fine.vertex[i] = {Real100(d.a), Real100(d.b), Real100(d.xy), Real100(d.yz), Real100(d.xz)};
  }
  const auto t = characteristic_tensor(coarse)->tensor;
  const auto u = characteristic_tensor(fine)->tensor;
  EXPECT_NEAR(t.xx, static_cast<double>(u.xx), 1e-15);
  EXPECT_NEAR(t.yy, static_cast<double>(u.yy), 1e-15);
  EXPECT_NEAR(t.zz, static_cast<double>(u.zz), 1e-15);
}

TEST(CharacteristicTensor, HasTheSaddleOfTheModeAsItsCommutingOrthogonalTensor) {
  // The traceless D that commutes with it and is orthogonal to it is in the field, with
  // mode(D)^2 + mode(T)^2 = 1: for the rational witness mode(D) = -143/343 at the origin.
  const auto t =
      characteristic_tensor(witness::unit_tetrahedron<double>(witness::saddle_origin_rational));
  const auto& b = t->eigenvalues;
  const Deviator<double> d =
      deviator(SymmetricTensor<double>{b[1] - b[2], b[2] - b[0], b[0] - b[1], 0, 0, 0});
  EXPECT_NEAR(mode(d), -143.0 / 343, 1e-15);
  EXPECT_NEAR(mode(d) * mode(d) + t->mode * t->mode, 1, 1e-15);
}

TEST(CharacteristicTensor, RefusesWhatIsNotFinite) {
  auto field = witness::unit_tetrahedron<double>(witness::generic_1);
  field.vertex[3].yz = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(characteristic_tensor(field), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo
