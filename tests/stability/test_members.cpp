// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cell_signatures.hpp"
#include "compare_members.hpp"
#include "support/compared.hpp"
#include "support/generators.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo::test {
namespace {

constexpr std::array<const char*, 7> kLevels{"0",    "1/10", "-3/10",  "1/2",
                                             "-3/4", "9/10", "-99/100"};
struct LevelInTet {
  ModeValue mu;

  static LevelInTet draw(Random& random, int) {
    return {ModeValue::parse(kLevels[static_cast<std::size_t>(random.integer(0, 6))])};
  }
  Stability stability(const UncertainField& field) const {
    return level_stability(field, mu).tets[0];
  }
  std::pair<std::optional<std::string>, bool> signature(const TetMesh& mesh) const {
    const auto extraction = extract_with_topology(mesh, mu);
    return {cell_signatures(mesh, mu, extraction)[0], !extraction.surface.triangles.empty()};
  }
  std::vector<TetMesh> may_differ(const TetMesh& mesh, std::span<const double> radii) const {
    return members_that_may_differ(mesh, 0, radii, mu.approx(), 1);
  }
};

TEST(StableTetrahedra, AreTheSameInRandomMembers) {
  Compared compared("members of boxes", 100);
  expect_the_same_in_members(1, trials(40, 20), {20, false}, LevelInTet::draw, compared);
}

TEST(StableTetrahedra, AreTheSameInMembersMovedTowardsCriticalPoints) {
  Compared compared("members of boxes", 100);
  expect_the_same_in_members(100001, trials(8, 4), {0, true}, LevelInTet::draw, compared);
}

// The same with fields that shrink.
RC_GTEST_PROP(StableTetrahedra, HaveTheSameSheetsInAMember, ()) {
  const auto sample = *rc::gen::oneOf(normal_tet(), small_integer_tet());
  const double m = *mode_value();
  const double share = *rc::gen::element(1e-3, 1e-2, 5e-2);
  const auto mu = ModeValue::parse(std::to_string(m));
  const TetMesh mesh = reference_tet_mesh(sample.tensors);
  const auto radii = vertex_radii(mesh, {Uncertainty::Kind::relative, share, {}});
  const auto stability = level_stability(UncertainField(mesh, radii), mu);
  RC_PRE(stability.tets[0] == Stability::stable);
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh member = random_member(mesh, radii, random);
  const auto own = cell_signatures(mesh, mu, extract_with_topology(mesh, mu))[0];
  const auto other = cell_signatures(member, mu, extract_with_topology(member, mu))[0];
  RC_PRE(own && other);
  RC_ASSERT(*own == *other);
}

// Reasons that are exact cannot appear in a smaller box. (The others are lack of a proof.)
TEST(StableTetrahedra, StaySoIfTheRadiusShrinks) {
  Compared compared("tetrahedra that were stable before", 100);
  Random random(7);
  for (int k = 0; k < trials(10, 5); ++k) {
    TetMesh mesh = cube_mesh(3);
    fill_with_smooth_tensors(mesh, static_cast<std::uint64_t>(k), 4, 3);
    const auto mu = ModeValue::parse(kLevels[static_cast<std::size_t>(k) % kLevels.size()]);
    std::vector<Stability> last;
    for (const double share : {1e-1, 1e-2, 1e-3}) {
      const auto radii = vertex_radii(mesh, {Uncertainty::Kind::relative, share, {}});
      const auto now = level_stability(UncertainField(mesh, radii), mu).tets;
      for (std::size_t t = 0; t < last.size(); ++t)
        if (last[t] == Stability::stable) {
          ++compared;
          EXPECT_TRUE(now[t] == Stability::stable || now[t] >= Stability::crossings_of_edge);
        }
      last = now;
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
