// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "extract_case.hpp"
#include "support/special_meshes.hpp"

namespace tensortopo::test {
namespace {

// Vertices of the mesh lie on the level, and where their samples fall together a sheet is pinched
// at them. The extraction then goes on at a level that keeps off those vertices: edges, faces and
// tetrahedra around them are done once more.
TEST(SecondPass, TracesFacesWithMovedEdgesAgain) {
  Random random(33);
  const TetMesh mesh = special_mesh(MeshKind::sparse, random);
  const Extraction extraction = extract(mesh, "1/2");
  ASSERT_GT(extraction.statistics.vertices_on_level, 0u);
  ASSERT_GT(extraction.statistics.tets_nearby, 0u);
  const auto pinched = std::count_if(
      extraction.unresolved.begin(), extraction.unresolved.end(),
      [](const auto& cell) { return cell.reason == UnresolvedReason::inconsistent_samples; });
  EXPECT_EQ(pinched, 0);
  EXPECT_EQ(flaws(extraction, mesh, {.residuals = false, .coincidences = false}), "");
}

}  // namespace
}  // namespace tensortopo::test
