// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "curved_tet.hpp"
#include "extract_case.hpp"
#include "laws.hpp"
#include "tensortopo/field/critical_gaps.hpp"

namespace tensortopo::test {
namespace {

// Levels next to modes -1 and 1, where surfaces are thin tubes around degenerate curves.
class ThinLevels : public testing::TestWithParam<const char*> {};

TEST_P(ThinLevels, HaveTheSameTopologyInTwoPrecisions) {
  expect_agreement_with_fifty_digits(GetParam(), trials(15), 20250501);
}

TEST_P(ThinLevels, OfIndependentTensorsAreFlawless) {
  expect_flawless_surfaces(GetParam(), trials(5), 2, false, 20250510);
}

TEST_P(ThinLevels, OfSmoothFieldsAreFlawless) {
  expect_flawless_surfaces(GetParam(), trials(4), 3, true, 20250520);
}

INSTANTIATE_TEST_SUITE_P(Levels, ThinLevels,
                         testing::Values("999/1000", "-9999/10000", "999999/1000000",
                                         "999999999/1000000000", "-999999999/1000000000"));

TEST(ThinLevel, HasTheTopologyThatBruteForceSees) {
  expect_agreement_with_brute_force("997/1000", trials(60), 20250530);
}

// Where the tubes are just thick enough for it, a refinement at the level itself has the last word.
TEST(ThinLevel, HasTheSheetsThatARefinementFinds) {
  const std::uint64_t seed = 20250540;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int compared = 0, tubes = 0, several = 0, no_tubes = 0;
  for (int trial = 0; trial < trials(300); ++trial) {
    const TetTensors tensors = random.tet_tensors();
    for (const char* mode : {"996/1000", "-998/1000"}) {
      const CurvedTet c(tensors, ModeValue::parse(mode));
      ASSERT_TRUE(c.has_curves) << exact_text(tensors);
      auto plan = plan_tet(c.tet, c.simplex_case.level);
      ASSERT_TRUE(plan) << mode << '\n' << exact_text(tensors);
      const auto sheets = plan->sheets;
      if (sheets.empty()) continue;
      plan->leaves.reset();
      if (!add_leaves(c.tet, c.simplex_case.level, *plan)) continue;
      ++compared;
      (plan->tubes.empty() ? no_tubes : tubes) += plan->refined ? 1 : 0;
      several += sheets.size() > 1 ? 1 : 0;
      EXPECT_EQ(in_order(sheets), in_order(plan->sheets)) << mode << '\n' << exact_text(tensors);
    }
  }
  std::cout << compared << " compared, " << tubes << " of them tubes, " << no_tubes
            << " other refined ones, " << several << " with several sheets\n";
  EXPECT_GT(tubes, compared / 4);
  EXPECT_GT(no_tubes, compared / 50);
  EXPECT_GT(several, compared / 20);
}

// Between two levels without a critical value nothing changes, on edges as well as inside.
TEST(ThinLevel, HasTheTopologyOfEveryLevelWithoutACriticalValueInBetween) {
  const std::uint64_t seed = 20250550;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int compared = 0;
  for (int trial = 0; trial < trials(60); ++trial) {
    const TetTensors tensors = random.tet_tensors();
    const TetMesh mesh = reference_tet_mesh(tensors);
    for (const std::string sign : {"", "-"}) {
      const std::string own = sign + "999999/1000000";
      const auto gaps = critical_gaps(tensors, ModeValue::parse(own), 0.3);
      ASSERT_TRUE(gaps) << exact_text(tensors);
      const LocalTopology seen = topology_in_tet(extract(mesh, own));
      for (const char* other : {"99999/100000", "9999/10000", "999/1000", "99/100", "9/10"}) {
        const ModeValue mode = ModeValue::parse(sign + other);
        if (1 - mode.approx() * mode.approx() >= 0.99 * gaps->open_until) break;
        const Extraction there = extract(mesh, mode.text());
        if (!there.unresolved.empty()) continue;
        ++compared;
        EXPECT_EQ(topology_in_tet(there), seen) << sign << other << '\n' << exact_text(tensors);
      }
    }
  }
  std::cout << compared << " levels compared\n";
  EXPECT_GT(compared, trials(60));
}

}  // namespace
}  // namespace tensortopo::test
