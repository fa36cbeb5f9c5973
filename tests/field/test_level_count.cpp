// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <iostream>

#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/oracles/brute_force.hpp"
#include "support/trials.hpp"
#include "tensortopo/field/degenerate_arcs.hpp"
#include "tensortopo/field/level_count.hpp"

namespace tensortopo::test {
namespace {

// A level is the boundary of what is larger and of what is smaller.
TEST(LevelCount, HasOneLevelFromBothSides) {
  const std::uint64_t seed = 20250570;
  SCOPED_TRACE(seed);
  Random random(seed);
  int compared = 0, other_than_a_disc = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const TetTensors tensors = random.tet_tensors();
    for (const char* text : {"-9/10", "-1/5", "1/3", "4/5", "999/1000"}) {
      const ModeValue mode = ModeValue::parse(text);
      const auto has_clean_arcs = [&](const char* side) {
        return degenerate_arcs(tensors, {0, 0, 0, 0}, ModeValue::parse(side)).has_value();
      };
      if (!has_clean_arcs("9/10") || !has_clean_arcs("-9/10")) continue;
      const auto above = count_level(cell_critical_points(tensors), mode, 1),
                 below = count_level(cell_critical_points(tensors), mode, -1);
      if (!above || !below) continue;
      ++compared;
      other_than_a_disc += above->level() != 1 ? 1 : 0;
      EXPECT_EQ(above->level(), below->level()) << text << '\n' << exact_text(tensors);
    }
  }
  std::cout << compared << " compared, " << other_than_a_disc << " other than a disc\n";
  EXPECT_GT(compared, 800);
  EXPECT_GT(other_than_a_disc, 100);
}

// The sum over the sheets that brute force sees.
TEST(LevelCount, HasTheEulerCharacteristicThatBruteForceSees) {
  const std::uint64_t seed = 20250572;
  SCOPED_TRACE(seed);
  Random random(seed);
  const auto count_of = [](int count) { return static_cast<std::size_t>(trials(count)); };
  Compared compared("levels that brute force decides", count_of(60)),
      several("with several sheets", count_of(10));
  for (int trial = 0; trial < trials(60); ++trial) {
    const TetTensors tensors = random.tet_tensors();
    for (const char* text : {"-4/5", "1/3", "1/2"}) {
      const ModeValue mode = ModeValue::parse(text);
      if (!degenerate_arcs(tensors, {0, 0, 0, 0}, ModeValue::parse("9/10")) ||
          !degenerate_arcs(tensors, {0, 0, 0, 0}, ModeValue::parse("-9/10")))
        continue;
      const auto count = count_level(cell_critical_points(tensors), mode, 1);
      const auto seen = brute_force_topology(corners_of(tensors), mode.approx());
      if (!count || !seen) continue;
      int euler = 0;
      for (const auto& sheet : seen->components) euler += sheet.euler;
      EXPECT_EQ(count->level(), euler) << text << '\n' << exact_text(tensors);
      ++compared;
      several.count(seen->components.size() > 1);
    }
  }
}

// What critical points between two levels change is what tells their counts apart.
TEST(LevelCount, ChangesByWhatIsBetweenTwoLevels) {
  const std::uint64_t seed = 20250571;
  SCOPED_TRACE(seed);
  Random random(seed);
  int compared = 0, changed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const TetTensors tensors = random.tet_tensors();
    const auto half = ModeValue::parse("1/2"), near = ModeValue::parse("-99/100"),
               far = ModeValue::parse("-1/3");
    for (const int side : {1, -1})
      for (const auto& mode : {near, far}) {
        const auto& from = side > 0 ? half : mode;
        const auto& to = side > 0 ? mode : half;
        const auto first = count_level(cell_critical_points(tensors), from, side),
                   last = count_level(cell_critical_points(tensors), to, side);
        const auto change = count_change(cell_critical_points(tensors), from, to, side);
        if (!first || !last) continue;
        ++compared;
        ASSERT_TRUE(change) << exact_text(tensors);
        changed += change->inside != 0 || change->boundary != 0 ? 1 : 0;
        EXPECT_EQ(first->inside + change->inside, last->inside) << exact_text(tensors);
        EXPECT_EQ(first->boundary + change->boundary, last->boundary) << exact_text(tensors);
        EXPECT_EQ(first->bridges + change->bridges, last->bridges) << exact_text(tensors);
      }
  }
  std::cout << compared << " compared, " << changed << " changed\n";
  EXPECT_GT(compared, 400);
  EXPECT_GT(changed, 100);
}

}  // namespace
}  // namespace tensortopo::test
