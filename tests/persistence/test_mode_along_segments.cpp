// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/field/critical_points.hpp"
#include "tensortopo/field/mode_along_segments.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

Deviator<double> at(const TetTensors& tensors, const TetWeights& weights) {
  Deviator<double> sum{};
  for (std::size_t i = 0; i < 4; ++i) sum = sum + weights[i] * deviator(tensors[i]);
  return sum;
}

TetWeights random_weights(Random& random) {
  TetWeights weights;
  for (double& w : weights) w = random.uniform();
  return weights;
}

// What is proved holds at samples; and what holds by a margin at samples is proved.
TEST(ModeAlongSegments, ProofsAgreeWithSamples) {
  Random random(1);
  Compared proved("segments proved", 300), refused("segments refused", 300);
  for (int trial = 0; trial < 2000; ++trial) {
    const TetTensors tensors = random.tet_tensors();
    const TetWeights from = random_weights(random), to = random_weights(random);
    double least = 1;
    for (int i = 0; i <= 100; ++i) {
      TetWeights weights;
      for (std::size_t k = 0; k < 4; ++k) weights[k] = from[k] + i / 100.0 * (to[k] - from[k]);
      least = std::min(least, mode(at(tensors, weights)));
    }
    const double level = least + 0.2 * (random.uniform() - 0.5);
    const bool is_proved =
        is_mode_above(deviator_box(tensors, from), deviator_box(tensors, to), level);
    if (is_proved) {
      EXPECT_GE(least, level);
    }
    if (least > level + 0.02) {
      EXPECT_TRUE(is_proved) << least << ' ' << level;
    }
    proved.count(is_proved);
    refused.count(!is_proved);
  }
}

// Next to degenerate tensors, where 1 - mode is below the rounding of the quotient.
TEST(ModeAlongSegments, IsProvedNextToModeOne) {
  const SymmetricTensor<double> near{2, -1 + 1e-7, -1 - 1e-7, 0, 0, 0};
  const TetTensors tensors{near, near, near, near};
  const auto box = deviator_box(tensors, {1, 0, 0, 0});
  EXPECT_TRUE(is_mode_above(box, box, 1 - 1e-13));
  EXPECT_FALSE(is_mode_above(box, box, 1 - 1e-16));
  EXPECT_FALSE(is_mode_above(box, box, 1));
}

TEST(ModeAlongSegments, RisesFromVerticesAreRises) {
  Random random(2);
  Compared rises("rises", 400), whole("whole edges", 100);
  for (int trial = 0; trial < 1000; ++trial) {
    TetTensors tensors = random.tet_tensors();
    if (trial % 2 == 0) tensors[1] = tensors[0] + 0.2 * tensors[1];
    Departure departure;
    departure.weights = {1, 0, 0, 0};
    departure.towards = {0, 1, 0, 0};
    departure.deviator = deviator_box(tensors, departure.weights);
    const double level = mode_range(departure.deviator)[1];
    const auto reached = rise_from(tensors, departure, level);
    const auto point = critical_vertex(tensors[0], std::vector{tensors[1]});
    ASSERT_NE(point.towards[0], Verdict::unknown);
    EXPECT_EQ(reached.has_value(), point.towards[0] == Verdict::positive);
    if (!reached) continue;
    double last = mode(deviator(tensors[0]));
    for (int i = 1; i <= 20; ++i) {
      TetWeights weights{};
      for (std::size_t k = 0; k < 2; ++k)
        weights[k] = (1 - i / 20.0) * departure.weights[k] + i / 20.0 * (*reached)[k];
      const double now = mode(at(tensors, weights));
      EXPECT_GT(now, last);
      last = now;
    }
    ++rises;
    whole.count((*reached)[0] == 0);
  }
}

}  // namespace
}  // namespace tensortopo::test
