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

class DrawnAsGraphs : public testing::TestWithParam<const char*> {};

// Neighbours that are meshed on the manifold included: no seam, no hole, every vertex on the level.
TEST_P(DrawnAsGraphs, SheetsOfRealFieldsAreFlawlessAndOfTheSameTopology) {
  const std::string mode = GetParam();
  std::size_t graphs = 0, rescued = 0;
  for (const auto& file : bundled_files()) {
    SCOPED_TRACE(file.filename().string() + " at " + mode);
    const TetMesh mesh = read(file);
    const Extraction graph = extract_by(mesh, mode, MeshingMethod::graph);
    const Extraction manifold = extract_by(mesh, mode, MeshingMethod::manifold);
    EXPECT_EQ(flaws(graph, mesh), "");
    EXPECT_EQ(summary(graph.surface), summary(manifold.surface));
    EXPECT_EQ(unresolved_text(graph), unresolved_text(manifold));
    // There only where the chart would ask for many more samples.
    EXPECT_LE(manifold.statistics.sheets_graph, graph.statistics.sheets_graph);
    rescued += manifold.statistics.sheets_graph;
    EXPECT_LE(graph.statistics.sheets_manifold, manifold.statistics.sheets_manifold);
    graphs += graph.statistics.sheets_graph;
  }
  EXPECT_GT(graphs, rescued);
  EXPECT_GT(rescued, 0u);
}

INSTANTIATE_TEST_SUITE_P(Levels, DrawnAsGraphs, testing::Values("0", "1/2"));

TEST(GraphMesher, GivesRandomSheetsTheirTopologyAndArea) {
  SCOPED_TRACE(announce(20260801));
  Random random(20260801);
  std::size_t graphs = 0;
  for (const char* mode : {"1/10", "-1/2"}) {
    double sum = 0, off = 0;
    for (int k = 0; k < trials(25); ++k) {
      // Where tensors differ more a graph is rare.
      auto tensors = random.tet_tensors();
      for (auto& t : tensors) t = 0.5 * tensors[0] + 0.5 * t;
      const TetMesh mesh = reference_tet_mesh(tensors);
      const Extraction graph = extract_by(mesh, mode, MeshingMethod::graph, 8);
      const Extraction manifold = extract_by(mesh, mode, MeshingMethod::manifold, 8);
      EXPECT_EQ(flaws(graph, mesh), "");
      EXPECT_EQ(summary(graph.surface), summary(manifold.surface));
      graphs += graph.statistics.sheets_graph;
      sum += area(manifold.surface);
      off += std::abs(area(graph.surface) - area(manifold.surface));
    }
    EXPECT_LT(off, 0.01 * sum) << "mode " << mode << ": " << off << " of " << sum;
  }
  EXPECT_GT(graphs, 0u);
}

}  // namespace
}  // namespace tensortopo::test
