// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "plane/level_curves.hpp"
#include "plane/real_zeros.hpp"
#include "support/fields/witness_fields.hpp"

namespace tensortopo::theory {
namespace {

// Of a product of linear factors b x - a, given as pairs (a, b).
Polynomial with_zeros(const std::vector<std::array<int, 2>>& zeros) {
  Polynomial product(1);
  for (const auto& [a, b] : zeros) {
    product = product * (Polynomial(b) * Polynomial::variable() - Polynomial(a));
  }
  return product;
}

TEST(RealZeros, AreApartAndInOrder) {
  const Polynomial x = Polynomial::variable();
  const Polynomial p = (x * x - Polynomial(2)) * with_zeros({{0, 1}, {1, 1}, {1, 1024}, {-3, 7}}) *
                       (x * x + Polynomial(1));
  const RealZeros zeros(p);
  ASSERT_EQ(zeros.count(), 6u);
  const auto n = Sign::negative, o = Sign::zero, s = Sign::positive;
  EXPECT_EQ(zeros.signs(x), (std::vector<Sign>{n, n, o, s, s, s}));
  EXPECT_EQ(zeros.signs(x - Polynomial(1)), (std::vector<Sign>{n, n, n, n, o, s}));
  // 1414213562 / 10^9 is below the root of 2, by less than 10^-9.
  EXPECT_EQ(zeros.signs(with_zeros({{1414213562, 1000000000}})),
            (std::vector<Sign>{n, n, n, n, n, s}));
  EXPECT_EQ(zeros.signs(Polynomial()), std::vector<Sign>(6, o));
  EXPECT_EQ(zeros.sign(x * x - Polynomial(2), 0), o);
  EXPECT_EQ(RealZeros(x * x + Polynomial(1)).count(), 0u);
  EXPECT_EQ(RealZeros(Polynomial(-5)).count(), 0u);
}

RC_GTEST_PROP(RealZeros, HaveTheSignsOfFactors, ()) {
  const auto numbers = *rc::gen::container<std::set<int>>(rc::gen::inRange(-20, 21));
  std::vector<std::array<int, 2>> factors;
  for (const int a : numbers) factors.push_back({a, 3});
  const RealZeros zeros(with_zeros(factors));
  RC_ASSERT(zeros.count() == numbers.size());
  const int other = *rc::gen::inRange(-20, 21);
  std::vector<Sign> expected;
  for (const int a : numbers) expected.push_back(static_cast<Sign>((a > other) - (a < other)));
  RC_ASSERT(zeros.signs(with_zeros({{other, 3}})) == expected);
}

RC_GTEST_PROP(Polynomial, DividesItsProducts, ()) {
  const auto drawn = [] {
    Polynomial p(*rc::gen::inRange(-9, 10));
    for (int power = 1; power < 5; ++power) {
      p.set_coefficient(power, Integer(*rc::gen::inRange(-9, 10)));
    }
    return p;
  };
  const Polynomial p = drawn(), q = drawn();
  RC_PRE(!p.is_zero() && !q.is_zero());
  RC_ASSERT(divides(q, p * q));
  RC_ASSERT(divides(p, quotient(p * q, q)));
  RC_ASSERT(divides(q, greatest_common_divisor(p * q, q)));
  RC_ASSERT(!is_squarefree(p * q * q) || q.degree() == 0);
  // A remainder has the sign of p at the zeros of q.
  RC_PRE(is_squarefree(q));
  const RealZeros zeros(q);
  RC_ASSERT(zeros.signs(remainder(p, q)) == zeros.signs(p));
}

Plane plane_of_witness(const test::PlanarWitness& witness) {
  TriangleField<Rational> field;
  const auto corners = witness.corners();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& t = corners[i];
    field.vertex[i] = deviator(tensor_cast<Rational>(t));
  }
  return *plane_of(field);
}

Rational square_of(const test::Fraction& mode) {
  const Rational mu = Rational(mode.numerator) / Rational(mode.denominator);
  return mu * mu;
}

TEST(LevelCurves, AreClosedAsInTheWitnesses) {
  int compared = 0;
  for (const test::PlanarWitness& witness : test::planar_witnesses()) {
    const Plane plane = plane_of_witness(witness);
    for (const test::CurveCase& expected : witness.curves) {
      if (expected.mode.numerator == 0 || expected.tangent) continue;
      const auto curves = LevelCurves::trace(plane, square_of(expected.mode), 20000);
      ASSERT_TRUE(curves) << witness.name << ' ' << expected.mode.value();
      const Sign sign = expected.mode.numerator > 0 ? Sign::positive : Sign::negative;
      EXPECT_EQ(curves->closed_count(sign), expected.closed_loops)
          << witness.name << ' ' << expected.mode.value();
      ++compared;
    }
  }
  EXPECT_GE(compared, 25);
}

TEST(LevelCurves, AreNotResolvedWhereTheyTouchASide) {
  const Plane plane = plane_of_witness(test::planar_witness("tangent_edge"));
  EXPECT_FALSE(LevelCurves::trace(plane, square_of({4, 5}), 2000));
  EXPECT_TRUE(LevelCurves::trace(plane, square_of({81, 100}), 2000));
  EXPECT_TRUE(LevelCurves::trace(plane, square_of({79, 100}), 2000));
}

TEST(LevelCurves, AreNotResolvedWhereACornerIsOnThem) {
  // diag(11, 2, -13) has mode -143 / 343.
  const auto diagonal = [](int x, int y, int z) {
    return deviator(SymmetricTensor<Rational>{Rational(x), Rational(y), Rational(z)});
  };
  Deviator<Rational> shear;
  shear.xy = 1;
  const auto plane =
      plane_of(TriangleField<Rational>{{diagonal(11, 2, -13), diagonal(1, 1, -2), shear}});
  ASSERT_TRUE(plane);
  EXPECT_FALSE(LevelCurves::trace(*plane, square_of({143, 343}), 2000));
}

TEST(LevelCurves, SurroundWhatIsInsideThem) {
  const Plane plane = plane_of_witness(test::planar_witness("ring_threefold_weak"));
  const CriticalSystem system = critical_system(plane);
  const auto kinds = real_points(plane, system.critical);
  // Below the mode of the saddles a curve inside all of them and one outside; above it one around
  // each maximum.
  const std::vector<std::pair<test::Fraction, std::vector<int>>> cases = {{{9, 10}, {1, 7}},
                                                                          {{97, 100}, {1, 1, 1}}};
  for (const auto& [mode, expected] : cases) {
    const auto curves = LevelCurves::trace(plane, square_of(mode), 20000);
    ASSERT_TRUE(curves);
    const auto cells = curves->cells_of(system.critical);
    std::vector<int> surrounded;
    for (std::size_t k = 0; k < curves->closed().size(); ++k) {
      EXPECT_FALSE(curves->surrounds_a_corner(k));
      if (curves->closed()[k].mode != Sign::positive) continue;
      surrounded.push_back(0);
      for (const auto& cell : cells) {
        ASSERT_TRUE(cell && curves->is_empty(*cell));
        surrounded.back() += curves->surrounds(k, *cell);
      }
    }
    std::sort(surrounded.begin(), surrounded.end());
    EXPECT_EQ(surrounded, expected) << mode.value();
    EXPECT_EQ(curves->open_count(), 0u);
  }
}

}  // namespace
}  // namespace tensortopo::theory
