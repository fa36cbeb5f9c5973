// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Degenerate curves that are called stable, in members of boxes.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>

#include "cell_signatures.hpp"
#include "compare_members.hpp"
#include "support/compared.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo::test {
namespace {

std::optional<std::string> signature(const TetMesh& mesh, Degeneracy kind) {
  return curve_signatures(mesh, extract_degenerate_curves(mesh, kind))[0];
}

struct CurvesInTet {
  Degeneracy kind;

  static CurvesInTet draw(Random&, int k) {
    return {k % 2 == 0 ? Degeneracy::linear : Degeneracy::planar};
  }
  Stability stability(const UncertainField& field) const {
    return curve_stability(field, kind).tets[0];
  }
  std::pair<std::optional<std::string>, bool> signature(const TetMesh& mesh) const {
    auto text = test::signature(mesh, kind);
    const bool is_present = text && !text->empty();
    return {std::move(text), is_present};
  }
  std::vector<TetMesh> may_differ(const TetMesh& mesh, std::span<const double> radii) const {
    return members_that_may_differ(mesh, 0, radii, kind, 1);
  }
};

TEST(StableCurves, AreTheSameInRandomMembers) {
  Compared compared("members of boxes", 100);
  expect_the_same_in_members(1, trials(40), {20, false}, CurvesInTet::draw, compared);
}

TEST(StableCurves, AreTheSameInMembersMovedTowardsDegenerateTensors) {
  Compared compared("members of boxes", 100);
  expect_the_same_in_members(200001, trials(12), {0, true}, CurvesInTet::draw, compared);
}

// Of the tetrahedra of random fields that are not stable, at least half differ in a member.
TEST(UnstableCurves, DifferInSomeMemberInHalfOfTheCases) {
  struct Count {
    int all = 0, differ = 0;
  };
  std::map<std::string_view, Count> counts;
  Compared compared("tetrahedra that are not stable", 20);
  int differ = 0;
  for (int k = 0; k < trials(120); ++k) {
    Random random(700 + static_cast<std::uint64_t>(k));
    const TetMesh mesh = reference_tet_mesh(random.tet_tensors());
    const auto kind = k % 2 == 0 ? Degeneracy::linear : Degeneracy::planar;
    const double share = k % 4 < 2 ? 0.01 : 0.1;
    const auto radii = vertex_radii(mesh, {Uncertainty::Kind::relative, share, {}});
    const Stability stability = curve_stability(UncertainField(mesh, radii), kind).tets[0];
    if (stability == Stability::stable) continue;
    const auto own = signature(mesh, kind);
    if (!own) continue;
    ++compared;
    Count& count = counts[name_of(stability)];
    ++count.all;
    for (const TetMesh& member : members_that_may_differ(mesh, 0, radii, kind, 2)) {
      const auto other = signature(member, kind);
      if (!other || *other == *own) continue;
      ++count.differ, ++differ;
      break;
    }
  }
  for (const auto& [reason, count] : counts)
    std::cout << reason << ": " << count.all << ", of which a member differs: " << count.differ
              << '\n';
  EXPECT_GE(2 * differ, static_cast<int>(compared.so_far()));
}

/// What is kept of a component in every member: its tetrahedra, with the arcs in each, and whether
/// it is closed.
std::map<std::string, int> components_of(const CurveMesh& curves, const std::vector<char>& which) {
  std::map<CurveMesh::Index, std::multiset<TetMesh::Index>> tets;
  std::map<CurveMesh::Index, std::map<CurveMesh::Index, int>> ends;
  for (std::size_t i = 0; i < curves.lines.size(); ++i) {
    const auto c = curves.component[i];
    tets[c].insert(curves.tet[i]);
    ++ends[c][curves.lines[i].front()], ++ends[c][curves.lines[i].back()];
  }
  std::map<std::string, int> result;
  for (const auto& [c, held] : tets) {
    if (!which.empty() && !which[as_size(c)]) continue;
    const auto& at = ends[c];
    const bool closed =
        std::none_of(at.begin(), at.end(), [](const auto& end) { return end.second == 1; });
    std::string text = closed ? "closed" : "open";
    for (const auto t : held) text += " " + std::to_string(t);
    ++result[text];
  }
  return result;
}

TEST(StableCurves, AsComponentsAreInEveryMember) {
  Compared compared("stable components in members", 10);
  for (int k = 0; k < trials(20); ++k) {
    Random random(1200 + static_cast<std::uint64_t>(k));
    TetMesh mesh = cube_mesh(3);
    fill_with_smooth_tensors(mesh, 1200 + static_cast<std::uint64_t>(k), 4, 3);
    const auto kind = k % 2 == 0 ? Degeneracy::linear : Degeneracy::planar;
    const auto radii =
        vertex_radii(mesh, {Uncertainty::Kind::relative, k % 4 < 2 ? 1e-4 : 1e-3, {}});
    const auto extraction = extract_degenerate_curves(mesh, kind);
    auto stability = curve_stability(UncertainField(mesh, radii), kind);
    mark_unresolved(extraction.unresolved, stability);
    const auto own =
        components_of(extraction.curves, stable_curves(mesh, extraction.curves, stability));
    for (int i = 0; i < 4 && !own.empty(); ++i) {
      const TetMesh member = random_member(mesh, radii, random);
      auto others = components_of(extract_degenerate_curves(member, kind).curves, {});
      for (const auto& [component, count] : own) {
        ++compared;
        EXPECT_GE(others[component], count) << "field " << k << ": " << component;
      }
    }
  }
}

TEST(CurveStability, OfADegenerateVertexOrEdgeIsNone) {
  // Degenerate at its first vertex; the others are far from it.
  TetTensors tensors{{{2, -1, -1, 0, 0, 0},
                      {1, 0, -1, 0, 0, 0},
                      {1, 0, -1, 0.1, 0, 0},
                      {1, 0.1, -1.1, 0, 0.1, 0}}};
  const auto first_reason = [&](double radius) {
    const TetMesh mesh = reference_tet_mesh(tensors);
    const UncertainField field(mesh, std::vector<double>(4, radius));
    return curve_stability(field, Degeneracy::linear).tets[0];
  };
  EXPECT_EQ(first_reason(0), Stability::degenerate_vertex);
  tensors[0] = {2, -0.9, -1.1, 0, 0, 0};  // 0.1 sqrt(2) from it
  EXPECT_NE(first_reason(0.14), Stability::degenerate_vertex);
  EXPECT_EQ(first_reason(0.142), Stability::degenerate_vertex);
  // Between two vertices that differ in the plane across the common axis only.
  tensors[1] = {2, -1.1, -0.9, 0, 0, 0};
  EXPECT_EQ(first_reason(0), Stability::degenerate_edge);
  EXPECT_EQ(first_reason(3), Stability::isotropic_within_radius);
}

}  // namespace
}  // namespace tensortopo::test
