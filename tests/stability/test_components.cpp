// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>

#include "cell_signatures.hpp"
#include "members.hpp"
#include "support/compared.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo::test {
namespace {

/// A component, found again in another surface by any of its crossings.
struct Component {
  std::set<TetMesh::Index> tets;
  long euler_characteristic = 0, boundary_loops = 0;
  friend bool operator==(const Component&, const Component&) = default;
};

std::map<std::string, Component> components_by_crossing(const Extraction& extraction) {
  const SurfaceMesh& surface = extraction.surface;
  const auto invariants = surface_invariants(surface);
  std::vector<Component> components(invariants.components);
  for (std::size_t i = 0; i < components.size(); ++i) {
    components[i].euler_characteristic = invariants.parts[i].euler_characteristic;
    components[i].boundary_loops = invariants.parts[i].boundary_loops;
  }
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    components[as_size(surface.component[i])].tets.insert(surface.tet[i]);
  const auto names = names_of_crossings(extraction);
  std::map<std::string, Component> result;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const auto v : surface.triangles[i])
      if (!names[as_size(v)].empty())
        result[names[as_size(v)]] = components[as_size(surface.component[i])];
  return result;
}

void expect_stable_components(const TetMesh& mesh, const ModeValue& mu,
                              std::span<const double> radii, int members, Random& random,
                              Compared& compared) {
  const auto extraction = extract_with_topology(mesh, mu);
  auto stability = level_stability(UncertainField(mesh, radii), mu);
  mark_unresolved(extraction.unresolved, stability);
  const auto surface = surface_stability(mesh, extraction.surface, stability);
  const auto names = names_of_crossings(extraction);
  const auto own = components_by_crossing(extraction);
  std::set<std::string> stable;
  for (std::size_t i = 0; i < extraction.surface.triangles.size(); ++i) {
    if (!surface.components[as_size(extraction.surface.component[i])]) continue;
    EXPECT_TRUE(surface.triangles[i]);
    for (const auto v : extraction.surface.triangles[i])
      if (!names[as_size(v)].empty()) stable.insert(names[as_size(v)]);
  }
  for (int i = 0; i < members && !stable.empty(); ++i) {
    const TetMesh member = random_member(mesh, radii, random);
    const auto others = components_by_crossing(extract_with_topology(member, mu));
    ++compared;
    for (const auto& name : stable) {
      const auto found = others.find(name);
      ASSERT_NE(found, others.end()) << name;
      EXPECT_TRUE(found->second == own.at(name)) << name;
    }
  }
}

TEST(StableComponents, AreInEveryMember) {
  Compared compared("members of boxes with stable components", 20);
  for (int k = 0; k < trials(20, 10); ++k) {
    Random random(900 + static_cast<std::uint64_t>(k));
    TetMesh mesh = cube_mesh(3);
    fill_with_smooth_tensors(mesh, 900 + static_cast<std::uint64_t>(k), 4, 3);
    const auto mu = ModeValue::parse(k % 3 == 0 ? "0" : k % 3 == 1 ? "1/2" : "-9/10");
    const auto radii =
        vertex_radii(mesh, {Uncertainty::Kind::relative, k % 2 == 0 ? 1e-3 : 1e-2, {}});
    expect_stable_components(mesh, mu, radii, 4, random, compared);
  }
  std::cout << compared.so_far() << " members compared\n";
}

TEST(SurfaceStability, OfAComponentNextToWhatWasLeftOutIsNone) {
  TetMesh mesh = cube_mesh(2);
  fill_with_smooth_tensors(mesh, 3);
  const auto mu = ModeValue::parse("1/10");
  const auto extraction = extract_with_topology(mesh, mu);
  ASSERT_FALSE(extraction.surface.triangles.empty());
  ASSERT_TRUE(extraction.unresolved.empty());
  auto stability = level_stability(UncertainField(mesh, std::vector<double>(27, 0)), mu);
  const auto before = surface_stability(mesh, extraction.surface, stability);
  ASSERT_EQ(before.components, std::vector<char>(before.components.size(), 1));
  // A neighbour without triangles of the first component.
  const auto& surface = extraction.surface;
  const TetMesh::Index tet = surface.tet[0];
  mark_unresolved(std::vector<UnresolvedCell>{{tet, UnresolvedReason::budget_exhausted}},
                  stability);
  const auto after = surface_stability(mesh, surface, stability);
  EXPECT_FALSE(after.components[as_size(surface.component[0])]);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    EXPECT_EQ(after.triangles[i] != 0, surface.tet[i] != tet);
  // The same if the triangles there are taken out, as an extraction would: the rest reaches it.
  SurfaceMesh rest = surface;
  rest.triangles.clear(), rest.tet.clear(), rest.component.clear();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (surface.tet[i] == tet) continue;
    rest.triangles.push_back(surface.triangles[i]);
    rest.tet.push_back(surface.tet[i]);
  }
  rest.component = surface_components(rest);
  const auto without = surface_stability(mesh, rest, stability);
  EXPECT_NE(without.components, std::vector<char>(without.components.size(), 1));
}

}  // namespace
}  // namespace tensortopo::test
