// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "tensortopo/theory/trial.hpp"

namespace tensortopo::theory {
namespace {

TEST(Random, IsTheSameEverywhere) {
  // The published sequence of splitmix64 for the seed 1234567.
  Random random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317u);
  EXPECT_EQ(random.next(), 3203168211198807973u);
  EXPECT_EQ(random.next(), 9817491932198370423u);
}

RC_GTEST_PROP(Random, StaysInRange, (std::uint64_t seed)) {
  Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const int n = random.integer(-3, 4), k = random.nonzero(3);
    RC_ASSERT(-3 <= n && n <= 4);
    RC_ASSERT(k != 0 && -3 <= k && k <= 3);
    const Rational part = random.part();
    RC_ASSERT(0 <= part && part <= 1);
  }
}

RC_GTEST_PROP(RandomBasis, IsOrthonormalAndRightHanded, (std::uint64_t seed)) {
  Random random(seed);
  const Basis e = random_basis(random);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) RC_ASSERT(dot(e[i], e[j]) == (i == j ? 1 : 0));
    RC_ASSERT(cross(e[i], e[(i + 1) % 3]) == e[(i + 2) % 3]);
  }
}

RC_GTEST_PROP(RandomTrial, HasTheFrameThatItClaims, (std::uint64_t seed)) {
  for (std::size_t i = 4; i <= 8; ++i) {
    const Trial trial = random_trial(seed, i);
    RC_ASSERT(trial.frame.has_value());
    const auto& l = trial.frame->eigenvalues;
    RC_ASSERT(l[0] >= l[1] && l[1] >= 0 && l[2] < 0 && l[0] + l[1] + l[2] == 0);
    const auto n = tensor_of(l, trial.frame->eigenvectors);
    for (const auto& d : trial.field.vertex) RC_ASSERT(inner(n, to_tensor(d)) == 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3<Rational>& e = trial.frame->eigenvectors[k];
      RC_ASSERT(n * e == l[k] * e);
    }
  }
}

RC_GTEST_PROP(RandomTrial, EveryTenthFieldIsDeficient, (std::uint64_t seed)) {
  RC_ASSERT(field_rank(random_trial(seed, 9).field) < 4);
}

TEST(RandomTrial, DependsOnSeedAndIndexOnly) {
  EXPECT_EQ(text(random_trial(5, 3).field), text(random_trial(5, 3).field));
  EXPECT_NE(text(random_trial(5, 3).field), text(random_trial(5, 4).field));
  EXPECT_NE(text(random_trial(5, 3).field), text(random_trial(6, 3).field));
  EXPECT_NE(text(random_trial(5, 3).field), text(random_trial(6, 2).field));
}

}  // namespace
}  // namespace tensortopo::theory
