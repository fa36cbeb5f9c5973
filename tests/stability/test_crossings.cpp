// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Crossings that are called stable, in members of boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "crossing_counts.hpp"
#include "members.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/stability/stability_run.hpp"

namespace tensortopo::test {
namespace {

/// Simplices by what is said of the crossings in them.
template <class Output>
std::map<Simplex, std::int32_t> told(const Output& output, Carrier kind,
                                     const std::vector<std::int32_t>& numbers) {
  std::map<Simplex, std::int32_t> result;
  EXPECT_EQ(numbers.size(), output.points.size());
  for (std::size_t v = 0; v < output.points.size(); ++v) {
    EXPECT_EQ(output.carrier[v] == kind, numbers[v] >= 0);
    if (output.carrier[v] == kind) result[output.carrier_vertices[v]] = numbers[v];
  }
  return result;
}

void expect_consistent(const StabilitySummary& summary, const std::vector<std::int32_t>& reasons,
                       const std::vector<std::int32_t>& stable) {
  ASSERT_EQ(reasons.size(), stable.size());
  std::size_t crossings = 0, of_stable = 0, of_reasons = 0;
  for (std::size_t v = 0; v < stable.size(); ++v) {
    EXPECT_EQ(stable[v], reasons[v] < 0 ? -1 : reasons[v] == 0 ? 1 : 0);
    EXPECT_NE(reasons[v], static_cast<std::int32_t>(Stability::unresolved));
    crossings += stable[v] >= 0, of_stable += stable[v] > 0;
  }
  for (const auto& [reason, count] : summary.crossing_reasons) of_reasons += count;
  EXPECT_EQ(summary.crossings, crossings);
  EXPECT_EQ(summary.stable_crossings, of_stable);
  EXPECT_EQ(of_stable + of_reasons, crossings);
}

struct Tally {
  std::map<std::int32_t, std::size_t> reasons;  ///< of simplices that are crossed
  std::size_t differ = 0;                       ///< not stable, and another number in a member
};

/// Each stable simplex is crossed as often in a member.
void compare(const std::map<Simplex, std::size_t>& own,
             const std::map<Simplex, std::int32_t>& reasons,
             const std::map<Simplex, std::size_t>& member, Compared& compared, Tally& tally) {
  for (const auto& [simplex, count] : own) {
    const auto found = member.find(simplex);
    const std::size_t other = found == member.end() ? 0 : found->second;
    if (reasons.at(simplex) == 0) {
      ++compared;
      EXPECT_EQ(count, other);
    } else {
      tally.differ += count != other;
    }
  }
}

/// Some are stable and others not, and of the latter some differ in a member.
void expect_several_kinds(const Tally& tally, const Compared& compared) {
  for (const auto& [reason, count] : tally.reasons)
    std::cout << count << ' ' << name_of(static_cast<Stability>(reason)) << ", ";
  std::cout << compared.so_far() << " compared; of others a member differs " << tally.differ
            << " times\n";
  EXPECT_GT(tally.reasons.size(), 1u);
  EXPECT_GT(tally.differ, 0u);
}

TEST(StableCrossings, OfSurfacesAreInEachMember) {
  Compared compared("stable crossings in members", 1000);
  Tally tally;
  for (int k = 0; k < trials(24, 12); ++k) {
    const auto seed = 4100 + static_cast<std::uint64_t>(k);
    Random random(seed);
    TetMesh mesh = cube_mesh(2);
    fill_with_smooth_tensors(mesh, seed, 4, 2);
    const auto mode = ModeValue::parse(k % 2 == 0 ? "1/2" : "0");
    const Uncertainty uncertainty{Uncertainty::Kind::relative, k % 4 < 2 ? 0.01 : 0.1, {}};
    const auto radii = vertex_radii(mesh, uncertainty);
    const Extraction extraction = extract_mode_surface<double>(mesh, mode);
    StabilityRun run(mesh, uncertainty);
    const StabilitySummary summary = run.add(mode, {}, extraction);
    ASSERT_EQ(run.arrays().size(), 4u);
    const auto& [name, numbers, none, of_points] = run.arrays()[2];
    EXPECT_EQ(name, "crossing_instability");
    EXPECT_TRUE(of_points && none.empty());
    expect_consistent(summary, numbers, run.arrays()[3].values);
    const auto reasons = told(extraction.surface, Carrier::edge, numbers);
    const auto own = crossings_of(extraction.surface, Carrier::edge);
    for (const auto& [simplex, reason] : reasons) ++tally.reasons[reason];
    for (int i = 0; i < 5; ++i) {
      const Extraction other =
          extract_mode_surface<double>(random_member(mesh, radii, random), mode);
      if (!other.unresolved.empty()) continue;
      compare(own, reasons, crossings_of(other.surface, Carrier::edge), compared, tally);
    }
  }
  expect_several_kinds(tally, compared);
}

TEST(StableCrossings, OfCurvesAreInEachMember) {
  Compared compared("stable crossings in members", 200);
  Tally tally;
  for (int k = 0; k < trials(12, 6); ++k) {
    const auto seed = 4200 + static_cast<std::uint64_t>(k);
    Random random(seed);
    TetMesh mesh = cube_mesh(3);
    fill_with_smooth_tensors(mesh, seed, 4, 2);
    const auto kind = k % 2 == 0 ? Degeneracy::linear : Degeneracy::planar;
    const Uncertainty uncertainty{Uncertainty::Kind::relative, k % 4 < 2 ? 0.001 : 0.01, {}};
    const auto radii = vertex_radii(mesh, uncertainty);
    const CurveExtraction extraction = extract_degenerate_curves(mesh, kind);
    StabilityRun run(mesh, uncertainty);
    const StabilitySummary summary = run.add(kind, {}, extraction);
    const auto& numbers = run.arrays()[2].line_values;
    expect_consistent(summary, numbers, run.arrays()[3].line_values);
    const auto reasons = told(extraction.curves, Carrier::face, numbers);
    const auto own = crossings_of(extraction.curves, Carrier::face);
    for (const auto& [simplex, reason] : reasons) ++tally.reasons[reason];
    for (int i = 0; i < 5; ++i) {
      const CurveExtraction other =
          extract_degenerate_curves(random_member(mesh, radii, random), kind);
      if (!other.unresolved.empty()) continue;
      compare(own, reasons, crossings_of(other.curves, Carrier::face), compared, tally);
    }
  }
  expect_several_kinds(tally, compared);
}

}  // namespace
}  // namespace tensortopo::test
