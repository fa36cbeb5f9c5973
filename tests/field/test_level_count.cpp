// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <iostream>

#include "support/random_fields.hpp"
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
      const auto above = count_level(tensors, mode, 1), below = count_level(tensors, mode, -1);
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

}  // namespace
}  // namespace tensortopo::test
