// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "cell_signatures.hpp"
#include "members.hpp"
#include "support/compared.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo::test {
namespace {

// Of the tetrahedra of random fields that are not stable, at least half differ in a member.
TEST(UnstableTetrahedra, DifferInSomeMemberInHalfOfTheCases) {
  struct Count {
    int all = 0, differ = 0;
  };
  std::map<std::string_view, Count> counts;
  Compared compared("tetrahedra that are not stable", 20);
  int differ = 0;
  for (int k = 0; k < trials(60, 30); ++k) {
    Random random(500 + static_cast<std::uint64_t>(k));
    const TetMesh mesh = reference_tet_mesh(random.tet_tensors());
    const auto mu = ModeValue::parse(k % 3 == 0 ? "0" : k % 3 == 1 ? "1/2" : "-9/10");
    const double share = k % 2 == 0 ? 0.01 : 0.1;
    const auto radii = vertex_radii(mesh, {Uncertainty::Kind::relative, share, {}});
    const Stability stability = level_stability(UncertainField(mesh, radii), mu).tets[0];
    if (stability == Stability::stable) continue;
    const auto own = cell_signatures(mesh, mu, extract_with_topology(mesh, mu))[0];
    if (!own) continue;
    ++compared;
    Count& count = counts[name_of(stability)];
    ++count.all;
    for (const TetMesh& member : members_that_may_differ(mesh, 0, radii, mu.approx(), 1)) {
      const auto other = cell_signatures(member, mu, extract_with_topology(member, mu))[0];
      if (!other || *other == *own) continue;
      ++count.differ, ++differ;
      break;
    }
  }
  for (const auto& [reason, count] : counts)
    std::cout << reason << ": " << count.all << ", of which a member differs: " << count.differ
              << '\n';
  EXPECT_GE(2 * differ, static_cast<int>(compared.so_far()));
  // These two reasons are exact.
  const Count& sides = counts["side_of_vertex"];
  EXPECT_GE(10 * sides.differ, 9 * sides.all);
}

}  // namespace
}  // namespace tensortopo::test
