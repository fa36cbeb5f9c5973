// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rational/exact_zeros.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/field/critical_points.hpp"
#include "tensortopo/field/exact_critical_points.hpp"
#include "tensortopo/field/planar_critical_points.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Tensor = SymmetricTensor<double>;
using Tensors = std::vector<Tensor>;

bool is_known(Verdict v) { return v == Verdict::positive || v == Verdict::negative; }

/// Whether two may be enclosures of the same point.
bool overlap(const CriticalPoint& a, const CriticalPoint& b) {
  bool near =
      a.low <= b.high && b.low <= a.high && a.gap_low <= b.gap_high && b.gap_low <= a.gap_high;
  for (std::size_t i = 0; i < 4; ++i) near &= std::abs(a.weights[i] - b.weights[i]) < 1e-9;
  return near;
}

/// What intervals decide is decided in the same way, and nothing is left open.
void compare(const std::vector<CriticalPoint>& exact, const std::vector<CriticalPoint>& intervals) {
  RC_PRE(std::all_of(intervals.begin(), intervals.end(),
                     [](const CriticalPoint& p) { return p.is_certain; }));
  RC_ASSERT(exact.size() == intervals.size());
  for (const CriticalPoint& p : exact) {
    const auto found = std::find_if(intervals.begin(), intervals.end(),
                                    [&](const CriticalPoint& q) { return overlap(p, q); });
    RC_ASSERT(found != intervals.end());
    RC_ASSERT(p.is_certain);
    RC_ASSERT(p.index == found->index);
    RC_ASSERT(p.towards.size() == found->towards.size());
    for (std::size_t i = 0; i < p.towards.size(); ++i) {
      RC_ASSERT(is_known(p.towards[i]));
      if (is_known(found->towards[i])) RC_ASSERT(p.towards[i] == found->towards[i]);
    }
  }
}

RC_GTEST_PROP(ExactCriticalPoints, AreThoseOfIntervals, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetTensors t = random.tet_tensors(), others = random.tet_tensors();
  const Tensors around(others.begin(), others.end());
  compare({exact_critical_vertex(t[0], around)}, {critical_vertex(t[0], around)});
  compare(exact_critical_points_on_edge({t[0], t[1]}, around),
          critical_points_on_edge({t[0], t[1]}, around));
  compare(exact_critical_points_on_face({t[0], t[1], t[2]}, around),
          critical_points_on_face({t[0], t[1], t[2]}, around));
  compare(exact_critical_points_in_tet(t), critical_points_in_tet(t));
}

/// As on a plane of symmetry, but for rounding of a relative size.
Tensor nearly_symmetric(Random& random, double rounding) {
  Tensor t = random.tet_tensors()[0];
  t.xy *= rounding;
  t.yz *= rounding;
  return t;
}

using Wide = Deviator<Real50>;

Wide wide(const Tensor& t) { return deviator(tensor_cast<Real50>(t)); }

const Real50 kStep("1e-13");

/// The derivative of the mode towards another tensor times twice the step, by differences of modes
/// in 50 digits.
Real50 rise(const Wide& t, const Wide& u) {
  return mode(Wide(t + kStep * u)) - mode(Wide(t - kStep * u));
}

/// The second derivative times four times the step's square.
Real50 bend(const Wide& t, const Wide& u, const Wide& v) {
  const auto at = [&](int i, int j) {
    return mode(Wide(t + Real50(i) * kStep * u + Real50(j) * kStep * v));
  };
  return at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1);
}

Verdict verdict(const Real50& x) { return x > 0 ? Verdict::positive : Verdict::negative; }

/// The zero of the derivative along an edge, by bisection around a place.
Real50 critical_place(const std::array<Wide, 2>& edge, double about) {
  const auto slope = [&](const Real50& x) {
    return rise(Wide(edge[0] + x * (edge[1] - edge[0])), Wide(edge[1] - edge[0]));
  };
  Real50 low = Real50(about) - Real50("1e-9"), high = Real50(about) + Real50("1e-9");
  const bool rises = slope(low) > 0;
  for (int i = 0; i < 110; ++i) {
    const Real50 middle = (low + high) / 2;
    ((slope(middle) > 0) == rises ? low : high) = middle;
  }
  return low;
}

// On an edge in a plane of symmetry a degenerate curve passes by at the distance of rounding: the
// mode rises from there to all sides but for less than intervals of doubles see.
TEST(ExactCriticalPoints, NextToPlanesOfSymmetryAreDecidedAsIn50Digits) {
  Random random(20);
  int points = 0, open = 0, signs = 0;
  for (int trial = 0; trial < full_or_short(200, 60); ++trial) {
    const std::array<Tensor, 2> edge{nearly_symmetric(random, 1e-13),
                                     nearly_symmetric(random, 1e-13)};
    const TetTensors others = random.tet_tensors();
    const Tensors around(others.begin(), others.end());
    const auto found = critical_points_on_edge(edge, around);
    const auto exact = exact_critical_points_on_edge(edge, around);
    if (std::any_of(found.begin(), found.end(),
                    [](const CriticalPoint& p) { return !p.is_certain; }))
      continue;
    ASSERT_EQ(exact.size(), found.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      ++points;
      ASSERT_TRUE(exact[i].is_certain);
      EXPECT_EQ(exact[i].index, found[i].index);
      const std::array<Wide, 2> ends{wide(edge[0]), wide(edge[1])};
      const Real50 x = critical_place(ends, exact[i].weights[1]);
      const Wide t = ends[0] + x * (ends[1] - ends[0]);
      const Real50 gap = 1 - mode(t) * mode(t);
      EXPECT_LE(Real50(exact[i].gap_low), gap * (1 + Real50("1e-12")));
      EXPECT_GE(Real50(exact[i].gap_high), gap * (1 - Real50("1e-12")));
      EXPECT_LE(exact[i].gap_high, exact[i].gap_low * (1 + 1e-5));
      for (std::size_t k = 0; k < around.size(); ++k) {
        open += !is_known(found[i].towards[k]);
        ++signs;
        EXPECT_EQ(exact[i].towards[k], verdict(rise(t, wide(around[k]))));
      }
    }
  }
  EXPECT_GT(points, full_or_short(100, 30));
  EXPECT_GT(signs, full_or_short(400, 120));
  EXPECT_GT(open, full_or_short(20, 6));
}

// The same in faces, where intervals do not see whether the point is a maximum or a saddle.
TEST(ExactCriticalPoints, OfFacesNextToPlanesOfSymmetryAreDecidedAsIn50Digits) {
  Random random(21);
  int points = 0, open = 0;
  for (int trial = 0; trial < full_or_short(100, 20); ++trial) {
    std::array<Tensor, 3> face;
    for (Tensor& t : face) t = nearly_symmetric(random, 1e-7);
    const TetTensors others = random.tet_tensors();
    const Tensors around(others.begin(), others.begin() + 2);
    const auto found = critical_points_on_face(face, around);
    const auto exact = exact_critical_points_on_face(face, around);
    const TriangleField<Real50> field{{wide(face[0]), wide(face[1]), wide(face[2])}};
    for (const auto& known : nondegenerate_critical_points(field)) {
      Real50 sum = 0;
      bool inside = true;
      for (const Real50& w : known.weights) sum += w, inside &= w > 0;
      if (!inside) continue;
      const auto is_it = [&](const CriticalPoint& p) {
        bool same = (p.low > 0) == (mode(known.tensor) > 0);
        for (std::size_t i = 0; i < 3; ++i)
          same &=
              std::abs(p.weights[i] - static_cast<double>(Real50(known.weights[i] / sum))) < 1e-9;
        return same;
      };
      const auto point = std::find_if(exact.begin(), exact.end(), is_it);
      ASSERT_NE(point, exact.end());
      ASSERT_TRUE(point->is_certain);
      ++points;
      open += std::none_of(found.begin(), found.end(), [&](const CriticalPoint& p) {
        return is_it(p) && p.is_certain &&
               std::all_of(p.towards.begin(), p.towards.end(), is_known);
      });
      const Wide t = Real50(1 / sum) * known.tensor;
      const Wide u = wide(face[1]) - wide(face[0]), v = wide(face[2]) - wide(face[0]);
      const Real50 uu = bend(t, u, u), uv = bend(t, u, v), vv = bend(t, v, v);
      EXPECT_EQ(point->index, uu * vv < uv * uv ? 1 : uu > 0 ? 0 : 2);
      for (std::size_t k = 0; k < around.size(); ++k)
        EXPECT_EQ(point->towards[k], verdict(rise(t, wide(around[k]))));
    }
  }
  EXPECT_GT(points, full_or_short(30, 8));
  EXPECT_GT(open, full_or_short(10, 3));
}

// Where a curve meets an edge exactly, the derivatives vanish: they are not said to have signs.
TEST(ExactCriticalPoints, OnADegenerateCurveHaveNoSigns) {
  Random random(22);
  int points = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::array<Tensor, 2> edge{nearly_symmetric(random, 0), nearly_symmetric(random, 0)};
    const TetTensors others = random.tet_tensors();
    const Tensors around(others.begin(), others.end());
    for (const auto& p : exact_critical_points_on_edge(edge, around)) {
      if (p.gap_high > 1e-9) continue;
      ++points;
      EXPECT_EQ(p.gap_low, 0);
      EXPECT_TRUE(std::none_of(p.towards.begin(), p.towards.end(), is_known));
    }
  }
  EXPECT_GT(points, 50);
}

TEST(ExactZeros, AreSeparatedAndHaveExactSigns) {
  using detail::ExactZeros;
  using detail::RationalPolynomial;
  const auto root = [](int numerator, int denominator) {
    return RationalPolynomial{Rational(-numerator), Rational(denominator)};
  };
  // Zeros 1/7 (double), 1/2, 5/7 and sqrt(1/3); 0 and 1 are at the ends.
  const RationalPolynomial irrational{Rational(-1), Rational(0), Rational(3)};
  const auto polynomial =
      root(1, 7) * root(1, 7) * root(1, 2) * root(5, 7) * root(0, 1) * root(1, 1) * irrational;
  const ExactZeros zeros(polynomial, Rational(0), Rational(1));
  ASSERT_EQ(zeros.zeros().size(), 4u);
  const std::array<double, 4> expected{1.0 / 7, 0.5, std::sqrt(1.0 / 3), 5.0 / 7};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& zero = zeros.zeros()[i];
    EXPECT_NEAR(static_cast<double>(zero.low), expected[i], 1e-15);
    EXPECT_NEAR(static_cast<double>(zero.high), expected[i], 1e-15);
    EXPECT_EQ(zeros.sign_at(zero, polynomial), Sign::zero);
    EXPECT_EQ(zeros.sign_at(zero, polynomial.prime()) == Sign::zero, i == 0);
    EXPECT_EQ(zeros.sign_at(zero, irrational) == Sign::zero, i == 2);
    EXPECT_EQ(zeros.sign_at(zero, root(1, 2)), i == 0   ? Sign::negative
                                               : i == 1 ? Sign::zero
                                                        : Sign::positive);
    if (i != 2) continue;
    // Rational numbers on both sides of sqrt(1/3), closer to it than doubles are to each other.
    const Rational unit("100000000000000000000000000000000000000");
    const Rational below("57735026918962576450914878050195745564"), above(below + 1);
    EXPECT_EQ(zeros.sign_at(zero, RationalPolynomial{Rational(-below), unit}), Sign::positive);
    EXPECT_EQ(zeros.sign_at(zero, RationalPolynomial{Rational(-above), unit}), Sign::negative);
  }
}

/// No interval around 0 is narrow in proportion to the numbers in it.
TEST(ExactZeros, AreFoundAtAndNextToZero) {
  using detail::ExactZeros;
  using detail::RationalPolynomial;
  const RationalPolynomial x{Rational(0), Rational(1)};
  const RationalPolynomial others{Rational(-1), Rational(0), Rational(3)};  // +-sqrt(1/3)
  const Rational tiny = Rational(1) / Rational("10000000000000000000000000000000000000000");
  for (const Rational& at : {Rational(0), tiny, Rational(-tiny)})
    for (const auto& polynomial :
         {RationalPolynomial{Rational(-at), Rational(1)},
          RationalPolynomial{Rational(-at), Rational(1)} * others,
          RationalPolynomial{Rational(-at * at * at), Rational(0), Rational(0), Rational(1)},
          RationalPolynomial{Rational(-at), Rational(1)} * others * others * x * x})
      for (const Rational& high : {Rational(1), Rational(3, 7)}) {
        const ExactZeros zeros(polynomial, Rational(-1), high);
        const auto is_there = [&](const ExactZeros::Zero& zero) {
          return zero.low <= at && at <= zero.high &&
                 zeros.sign_at(zero, RationalPolynomial{Rational(-at), Rational(1)}) == Sign::zero;
        };
        EXPECT_EQ(std::count_if(zeros.zeros().begin(), zeros.zeros().end(), is_there), 1);
      }
}

}  // namespace
}  // namespace tensortopo::test
