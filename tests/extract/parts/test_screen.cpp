// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/proofs/screen.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "extract/cases/extract_case.hpp"
#include "support/oracles/brute_force.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

// Also within 1e-1 ... 1e-17 of a degenerate tensor, where the arc cosine loses digits.
TEST(Screen, AnglesAreAsAccurateAsStated) {
  const std::uint64_t seed = 20240501;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  double worst = 0;
  for (int trial = 0; trial < trials(3000); ++trial) {
    SymmetricTensor<double> uniaxial{1, 1, -2, 0, 0, 0};
    if (trial % 2 != 0) {
      const double x = random.normal(), y = random.normal(), z = random.normal();
      uniaxial = {x * x, y * y, z * z, x * y, y * z, x * z};
    }
    const auto t = deviator(((trial % 3 != 0) ? -1.0 : 1.0) * uniaxial +
                            std::ldexp(1.0, -(trial % 57)) * random.tensor());
    const auto s = deviator(random.tensor());
    const Real50 exact = lode_angle(tensor_cast<Real50>(t));
    const double error = std::abs(static_cast<double>(exact - Real50(screen::lode_angle(t))));
    const auto near_t = t + std::ldexp(1.0, -(trial % 50)) * s;
    const double between =
        screen::angle(t, std::sqrt(norm_form(t)), near_t, std::sqrt(norm_form(near_t)));
    const double error_of_angle = std::abs(static_cast<double>(
        angle_between(tensor_cast<Real50>(t), tensor_cast<Real50>(near_t)) - Real50(between)));
    worst = std::max({worst, error, error_of_angle});
  }
  std::cout << "worst error of an angle " << worst << '\n';
  EXPECT_LT(worst, screen::kAngleError);
}

// As a function of the angle the error changes by less than 1e-6 for each radian, so between these
// places by less than 2e-10.
TEST(Screen, ArcCosineIsAsAccurateAsStated) {
  constexpr int kPlaces = 20000;
  double worst = 0;
  for (int k = 0; k <= kPlaces; ++k) {
    const double x = std::cos(3.141592653589793 * k / kPlaces);
    worst = std::max(worst, std::abs(static_cast<double>(acos(Real50(x)) -
                                                         Real50(screen::arc_cosine(x)))));
  }
  EXPECT_LT(worst, 2.25e-8);
  EXPECT_GT(worst, 1e-8);
}

TEST(Screen, NeverExcludesATetrahedronThatBruteForceSeesCrossed) {
  const std::uint64_t seed = 20240502;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int excluded = 0, crossed = 0;
  for (int trial = 0; trial < trials(6000); ++trial) {
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    TetTensors tensors = random.tet_tensors();
    const double spread = std::ldexp(1.0, -(trial % 5));
    for (std::size_t i = 1; i < 4; ++i) tensors[i] = tensors[0] + spread * tensors[i];
    const SimplexCase<double, 4> tet(tensors, mode);
    const bool excludes = screen::excludes(tet.simplex.tensors, tet.level.lode_angle);
    const LocalTopology seen = lattice_view(corners_of(tensors), mode.approx(), 12).topology;
    excluded += excludes;
    crossed += !seen.components.empty();
    EXPECT_FALSE(excludes && !seen.components.empty()) << exact_text(tensors);
  }
  std::cout << excluded << " excluded, " << crossed << " crossed\n";
  EXPECT_GT(excluded, 500);
  EXPECT_GT(crossed, 500);
}

// The bound is sharp: along a meridian the Lode angle changes as fast as the tensor turns.
TEST(Screen, ExcludesUpToTheLevelItselfAndNotBeyond) {
  EXPECT_TRUE(screen::excludes(0.5, 0.1, 0.61));
  EXPECT_TRUE(screen::excludes(0.5, 0.1, 0.39));
  EXPECT_FALSE(screen::excludes(0.5, 0.1, 0.6));
  EXPECT_FALSE(screen::excludes(0.5, 0.1, 0.4));
  EXPECT_FALSE(screen::excludes(0.5, 0.1, 0.5));
  EXPECT_FALSE(screen::excludes(0.0, 1.58, 1.0));
  EXPECT_FALSE(screen::excludes(0.5, std::nan(""), 1.0));
}

TEST(Screen, DoesNotExcludeTensorsThatCancel) {
  const auto t = deviator(SymmetricTensor<double>{2, -1, -1, 0, 0, 0});
  EXPECT_FALSE(screen::excludes(std::array{t, -1.0 * t}, 0.5));
  EXPECT_FALSE(screen::excludes(std::array{Deviator<double>{}, Deviator<double>{}}, 0.5));
}

}  // namespace
}  // namespace tensortopo::test
