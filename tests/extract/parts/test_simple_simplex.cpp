// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/proofs/simple_simplex.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "extract/cases/exact_edge.hpp"
#include "mode_of_deviator.hpp"
#include "support/oracles/exact_increase.hpp"
#include "extract/cases/extract_case.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

// Four tensors within `spread` of one of them, so that proofs close often: as in a smooth field.
template <std::size_t Vertices>
std::array<SymmetricTensor<double>, Vertices> nearby(Random& random, double spread) {
  std::array<SymmetricTensor<double>, Vertices> tensors;
  tensors[0] = random.tensor();
  for (std::size_t i = 1; i < Vertices; ++i) tensors[i] = tensors[0] + spread * random.tensor();
  return tensors;
}

// Random barycentric coordinates, now and then on the boundary.
template <std::size_t Vertices>
std::array<double, Vertices> random_weights(Random& random) {
  std::array<double, Vertices> w;
  double sum = 0;
  for (auto& x : w) {
    x = random.uniform() < 0.2 ? 0.0 : -std::log(1 - random.uniform());
    sum += x;
  }
  if (!(sum > 0)) w[0] = sum = 1;
  for (auto& x : w) x /= sum;
  return w;
}

template <std::size_t Vertices>
void expect_proofs_to_hold(std::uint64_t seed, int count) {
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int empty = 0, monotone = 0;
  for (int trial = 0; trial < count; ++trial) {
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const SimplexCase<double, Vertices> example(
        nearby<Vertices>(random, std::ldexp(2.0, -(trial % 6))), mode);
    const auto& tensors = example.simplex.tensors;
    const auto proof = prove_simplex(tensors, example.level);
    using Kind = typename SimplexProof<double, Vertices>::Kind;
    empty += proof.kind == Kind::empty, monotone += proof.kind == Kind::monotone;
    std::array<Deviator<Real50>, Vertices> wide;
    for (std::size_t i = 0; i < Vertices; ++i) wide[i] = tensor_cast<Real50>(tensors[i]);
    const auto mode_at = [&](const std::array<Real50, Vertices>& weights) {
      return mode_of_deviator(tensor_at(wide, weights));
    };
    const Real50 mu = to_scalar<Real50>(mode);
    int above = 0, below = 0;
    for (int sample = 0; sample < 12; ++sample) {
      const auto w = random_weights<Vertices>(random);
      std::array<Real50, Vertices> from;
      for (std::size_t i = 0; i < Vertices; ++i) from[i] = Real50(w[i]);
      const Real50 value = mode_at(from);
      ++(value > mu ? above : below);
      if (proof.kind != Kind::monotone) continue;
      // As far as the simplex goes along the direction, times a random factor.
      Real50 longest(1e9);
      for (std::size_t i = 0; i < Vertices; ++i)
        if (proof.direction[i] < 0) {
          const Real50 reach = -from[i] / Real50(proof.direction[i]);
          if (reach < longest) longest = reach;
        }
      if (!(longest > 0)) continue;
      std::array<Real50, Vertices> to;
      const Real50 step = longest * Real50(random.uniform());
      for (std::size_t i = 0; i < Vertices; ++i)
        to[i] = from[i] + step * Real50(proof.direction[i]);
      // The line crosses the level upwards only.
      if (step > 0 && value > mu) {
        EXPECT_GT(mode_at(to), mu) << "trial " << trial;
      }
    }
    if (proof.kind == Kind::empty) {
      EXPECT_TRUE(above == 0 || below == 0) << "trial " << trial;
      for (std::size_t i = 0; i < Vertices; ++i)
        EXPECT_EQ(example.simplex.above[i], above > 0) << "trial " << trial;
      for (std::size_t i = 0; i < Vertices; ++i)
        for (std::size_t j = i + 1; j < Vertices; ++j)
          EXPECT_TRUE(
              exact_crossings(example.mesh.tensors[i], example.mesh.tensors[j], mode).empty())
              << "trial " << trial;
    }
  }
  std::cout << Vertices << " vertices: " << empty << " empty, " << monotone << " monotone of "
            << count << '\n';
  EXPECT_GT(4 * empty, count / 4);
  EXPECT_GT(monotone, count / 8);
}

TEST(SimplexProof, OfATriangleHolds) { expect_proofs_to_hold<3>(20240401, trials(800)); }
TEST(SimplexProof, OfATetrahedronHolds) { expect_proofs_to_hold<4>(20240402, trials(800)); }

// The coefficients that a proof in doubles looks at have the signs that it says, in rationals.
TEST(SimplexProof, SignsThatAreCertainInDoubleAreExact) {
  const std::uint64_t seed = 20240403;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int certain = 0, hidden = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const SimplexCase<double, 4> example(nearby<4>(random, std::ldexp(1.0, -(trial % 50))), mode);
    const auto& tensors = example.simplex.tensors;
    std::array<Deviator<Rational>, 4> exact;
    for (std::size_t i = 0; i < 4; ++i) {
      // From the input's own bits, not from the rounded deviators.
      const auto& t = example.mesh.tensors[i];
      const auto r = tensor_cast<Rational>(t);
      exact[i] = Rational(std::ldexp(1.0, example.simplex.exponents[i])) * deviator(r);
    }
    const auto exact_forms = mode_forms(exact);
    const double norm = largest_norm(tensors);
    const auto forms = mode_forms(tensors);
    const auto bounds = norm_bounds(forms);
    const LevelIncrease<double, 4> increase(forms, bounds, example.level);
    const auto direction = likely_direction(increase, trial % 2 ? 0 : kLongSearch, trial % 3 == 0);
    const auto all_of_sign = [](const auto& p, int sign) {
      for (const auto& c : p.coefficients)
        if (!(Rational(sign) * c > 0)) return false;
      return true;
    };
    const Verdict increases = detail::increases_along(increase, direction, norm, 1);
    const Verdict empty = detail::is_empty(forms, bounds, example.level, norm, 1);
    hidden += increases == Verdict::unknown || empty == Verdict::unknown;
    if (increases != Verdict::unknown) {
      ++certain;
      EXPECT_EQ(increases == Verdict::positive,
                truly_increases(exact_forms, bounds, to_scalar<Rational>(mode), direction))
          << trial;
    }
    if (empty != Verdict::unknown) {
      ++certain;
      EXPECT_EQ(empty == Verdict::positive,
                all_of_sign(exact_forms.determinant, -example.level.sign) ||
                    truly_empty(exact_forms, bounds, to_scalar<Rational>(mode)))
          << trial;
    }
  }
  std::cout << certain << " certain verdicts, " << hidden << " trials with one hidden\n";
  EXPECT_GT(certain, trials(400) / 2);
  EXPECT_GT(hidden, 0);
}

// The linear bounds on the norm that proofs rest on hold for the input's own bits.
TEST(NormBounds, HoldInRationals) {
  const std::uint64_t seed = 20240405;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int bounded = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    const SimplexCase<double, 4> example(nearby<4>(random, std::ldexp(2.0, -(trial % 20))),
                                         ModeValue::parse("1/2"));
    const auto bounds = norm_bounds(mode_forms(example.simplex.tensors));
    if (!(bounds.lower > 0)) continue;
    ++bounded;
    EXPECT_LE(bounds.lower, 1);
    for (int sample = 0; sample < 10; ++sample) {
      const auto weights = random_weights<4>(random);
      SymmetricTensor<Rational> sum{};
      Rational upper = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto& t = example.mesh.tensors[i];
        const auto exact = tensor_cast<Rational>(t);
        const Rational scale(weights[i] * std::ldexp(1.0, example.simplex.exponents[i]));
        sum = sum + scale * exact;
        upper += Rational(weights[i]) * Rational(bounds.upper[i]);
      }
      const Rational square = norm_form(deviator(sum)), lower = Rational(bounds.lower) * upper;
      EXPECT_LE(square, upper * upper) << trial;
      EXPECT_GE(square, lower * lower) << trial;
    }
  }
  EXPECT_GT(2 * bounded, trials(400));
}

TEST(SimplexProof, OneCrossingIsRightToSturm) {
  const std::uint64_t seed = 20240404;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int proved = 0;
  for (int trial = 0; trial < trials(2000); ++trial) {
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const std::array<SymmetricTensor<double>, 2> ends{random.tensor(), random.tensor()};
    const SimplexCase<double, 2> edge(ends, mode);
    if (has_at_most_one_crossing(edge.simplex.tensors, edge.level) != Verdict::positive) continue;
    ++proved;
    EXPECT_LE(exact_crossings(ends[0], ends[1], mode).size(), 1u) << "trial " << trial;
  }
  EXPECT_GT(5 * proved, trials(2000));
}

}  // namespace
}  // namespace tensortopo::test
