// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "extract/cases/extract_case.hpp"

namespace tensortopo::test {
namespace {

// One sheet around three tubes: at the nearer of two levels, 1e-9 from mode 1, proved by counts,
// but by no cells that it could be meshed from.
TEST(RimSheets, AreDrawnAroundThinTubes) {
  const TetTensors tensors{
      {{1, 0, 0, 0, 1, 1}, {-1, -1, 1, 1, -1, 0}, {1, -1, -1, 0, 0, 1}, {-1, -1, -1, -1, 1, 1}}};
  const TetMesh mesh = reference_tet_mesh(tensors);
  ExtractOptions options;
  options.sampling.resolution = 20;
  const auto at = [&](const char* mode) {
    return extract_mode_surface<double>(mesh, ModeValue::parse(mode), options);
  };
  const auto far = at("999/1000"), near = at("999999999/1000000000");
  ASSERT_EQ(unresolved_text(far), "");
  EXPECT_EQ(far.statistics.sheets_loops, 0u);
  EXPECT_EQ(unresolved_text(near), "");
  EXPECT_EQ(flaws(near, mesh), "");
  EXPECT_GT(near.statistics.sheets_loops, 0u);
  // No critical value lies between the two modes.
  EXPECT_EQ(topology_in_tet(near), topology_in_tet(far));
}

}  // namespace
}  // namespace tensortopo::test
