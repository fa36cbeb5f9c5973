// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "extract/cases/bundled_fields.hpp"
#include "extract/cases/extract_case.hpp"
#include "support/surfaces/measures.hpp"

namespace tensortopo::test {
namespace {

Extraction extract_by(const TetMesh& mesh, const std::string& mode, MeshingMethod meshing,
                      double resolution = Sampling().resolution) {
  ExtractOptions options;
  options.sampling.resolution = resolution;
  options.meshing = meshing;
  return extract_mode_surface<double>(mesh, ModeValue::parse(mode), options);
}

class Bisection : public testing::TestWithParam<const char*> {};

// Neighbours that are meshed on the manifold included: no seam, no hole, every vertex on the level.
TEST_P(Bisection, GivesSheetsOfRealFieldsWithoutFlawsAndOfTheSameTopology) {
  const std::string mode = GetParam();
  std::size_t bisected = 0, on_manifold = 0;
  for (const auto& file : tried_files()) {
    SCOPED_TRACE(file.filename().string() + " at " + mode);
    const TetMesh mesh = read(file);
    const Extraction ours = extract_by(mesh, mode, MeshingMethod::bisection);
    const Extraction manifold = extract_by(mesh, mode, MeshingMethod::manifold);
    EXPECT_EQ(flaws(ours, mesh), "");
    EXPECT_EQ(summary(ours.surface), summary(manifold.surface));
    EXPECT_EQ(unresolved_text(ours), unresolved_text(manifold));
    EXPECT_EQ(manifold.statistics.sheets_bisected, 0u);
    bisected += ours.statistics.sheets_bisected;
    on_manifold += ours.statistics.sheets_manifold;
  }
  // Most sheets that are not small; others are neither discs nor tubes, or would have triangles
  // that intersect.
  EXPECT_GT(bisected, 4 * on_manifold);
}

INSTANTIATE_TEST_SUITE_P(Levels, Bisection, testing::Values("0", "1/2", "99/100"));

TEST(BisectionOfRandomSheets, GivesTheirTopologyAndArea) {
  SCOPED_TRACE(announce(20260801));
  Random random(20260801);
  std::size_t bisected = 0;
  for (const char* mode : {"1/10", "-1/2"}) {
    double sum = 0, off = 0;
    for (int k = 0; k < trials(25); ++k) {
      auto tensors = random.tet_tensors();
      for (auto& t : tensors) t = 0.5 * tensors[0] + 0.5 * t;
      const TetMesh mesh = reference_tet_mesh(tensors);
      const Extraction ours = extract_by(mesh, mode, MeshingMethod::bisection, 8);
      const Extraction manifold = extract_by(mesh, mode, MeshingMethod::manifold, 8);
      EXPECT_EQ(flaws(ours, mesh), "");
      EXPECT_EQ(summary(ours.surface), summary(manifold.surface));
      bisected += ours.statistics.sheets_bisected;
      sum += area(manifold.surface);
      off += std::abs(area(ours.surface) - area(manifold.surface));
    }
    EXPECT_LT(off, 0.01 * sum) << "mode " << mode << ": " << off << " of " << sum;
  }
  EXPECT_GT(bisected, 0u);
}

// Were all sheets bent evenly, four times the samples would make it a sixteenth.
TEST(BisectionOfRandomSheets, ComesCloserToTheLevelWithTheSamples) {
  SCOPED_TRACE(announce(20261127));
  Random random(20261127);
  double coarse = 0, fine = 0;
  for (int k = 0; k < trials(25); ++k) {
    auto tensors = random.tet_tensors();
    for (auto& t : tensors) t = 0.5 * tensors[0] + 0.5 * t;
    const TetMesh mesh = reference_tet_mesh(tensors);
    const auto area_at = [&](double resolution) {
      return area(extract_by(mesh, "1/10", MeshingMethod::bisection, resolution).surface);
    };
    const double exact = area_at(64);
    coarse += std::abs(area_at(2) - exact);
    fine += std::abs(area_at(8) - exact);
  }
  ASSERT_GT(coarse, 0);
  EXPECT_LT(fine, 0.5 * coarse);
}

}  // namespace
}  // namespace tensortopo::test
