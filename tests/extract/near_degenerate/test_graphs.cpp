// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "extract/cases/curved_tet.hpp"
#include "extract/cases/extract_case.hpp"
#include "support/oracles/brute_force.hpp"

namespace tensortopo::test {
namespace {

// Where the level is a graph in the whole tetrahedron, its loops alone say what sheets there are;
// brute force, which knows nothing of that, must see the same.
TEST(GraphSheets, AreThoseThatBruteForceSees) {
  const std::uint64_t seed = 20250610;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int compared = 0, discs = 0, with_holes = 0;
  for (int trial = 0; trial < trials(2500, 1250); ++trial) {
    TetTensors tensors = random.tet_tensors();
    // A common part brings the tensors together, so that graphs are frequent.
    const auto common = std::ldexp(1.0, trial % 3) * random.tensor();
    for (auto& t : tensors) t = t + common;
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const CurvedTet c(tensors, mode);
    ASSERT_TRUE(c.has_curves) << exact_text(tensors);
    const auto proved = prove_cell(c.tet, c.simplex_case.level);
    ASSERT_TRUE(proved) << mode.text() << '\n' << exact_text(tensors);
    if (proved->refined || proved->loops.size() < 2) continue;
    const auto seen = brute_force_topology(corners_of(tensors), mode.approx());
    if (!seen) continue;
    const auto& sheets = proved->sheets;
    std::vector<ComponentTopology> claimed;
    for (const auto& sheet : sheets)
      claimed.push_back({sheet.euler_characteristic, static_cast<int>(sheet.loops.size())});
    std::sort(claimed.begin(), claimed.end());
    EXPECT_EQ(claimed, seen->components) << mode.text() << '\n' << exact_text(tensors);
    ++compared;
    ++(sheets.size() == proved->loops.size() ? discs : with_holes);
  }
  std::cout << compared << " tetrahedra with several loops, " << discs << " times discs, "
            << with_holes << " times a sheet with holes\n";
  EXPECT_GT(compared, 50);
}

}  // namespace
}  // namespace tensortopo::test
