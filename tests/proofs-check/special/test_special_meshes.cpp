// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Small meshes in which everything that is special about tensors meets.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "extract/cases/extract_case.hpp"
#include "proofs-check/forgeries/forgery.hpp"
#include "support/fields/special_meshes.hpp"

namespace tensortopo::test {
namespace {

constexpr std::array kMeshModes{"0",    "1/2",     "-1/2",   "143/343",
                                "9/10", "-99/100", "1/1000", "-1/1000000000"};

/// Reasons that are no property of the field: a proof or a drawing did not come about.
bool is_for_want_of_a_proof(UnresolvedReason reason) {
  return reason == UnresolvedReason::budget_exhausted ||
         reason == UnresolvedReason::inconsistent_samples;
}

class SpecialMeshes : public testing::TestWithParam<MeshKind> {};

TEST_P(SpecialMeshes, GiveFlawlessSurfacesThatNoCheckerRefutes) {
  constexpr std::uint64_t kMeshSeed = 20241201;
  SCOPED_TRACE(announce(kMeshSeed));
  Random random(kMeshSeed + static_cast<std::uint64_t>(GetParam()));
  Court court("special_meshes");
  std::size_t tets = 0, unproved = 0, triangles = 0;
  std::string which;
  const int count = trials(TENSORTOPO_SPECIAL_MESHES);
  for (int trial = 0; trial < count; ++trial) {
    const TetMesh mesh = special_mesh(GetParam(), random);
    const std::string mode = kMeshModes[static_cast<std::size_t>(random.integer(0, 7))];
    SCOPED_TRACE("trial " + std::to_string(trial) + ", mode " + mode);
    const Extraction extraction = extract(mesh, mode);
    EXPECT_EQ(flaws(extraction, mesh, {.coincidences = false}), "");
    for (const auto& cell : extraction.unresolved) {
      if (!is_for_want_of_a_proof(cell.reason)) continue;
      ++unproved;
      TetTensors tensors;
      for (std::size_t i = 0; i < 4; ++i)
        tensors[i] = mesh.tensors[static_cast<std::size_t>(
            mesh.tets[static_cast<std::size_t>(cell.tet)][i])];
      which +=
          std::string(name_of(cell.reason)) + ", mode " + mode + '\n' + exact_text(tensors) + '\n';
    }
    tets += mesh.tets.size();
    triangles += extraction.surface.triangles.size();
    const std::string verdict = court.verdict(exhibit(mesh, {mode}));
    EXPECT_TRUE(verdict == "certified" || verdict == "undecided") << court.report();
  }
  EXPECT_GT(triangles, static_cast<std::size_t>(count));
  EXPECT_LE(100 * unproved, 100 + tets) << which;
}

INSTANTIATE_TEST_SUITE_P(Kinds, SpecialMeshes, testing::ValuesIn(all_mesh_kinds()),
                         [](const auto& kind) {
                           std::string name = name_of(kind.param);
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

}  // namespace
}  // namespace tensortopo::test
