// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "extract/cases/curve_checks.hpp"
#include "extract/cases/strata_laws.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

// Edges, faces and tetrahedra in one special position each, whose outcome is known.

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

// What is proved of the faces, in an extraction without flaw.
std::vector<LevelTopology::Face> proved_faces(const TetMesh& mesh, const std::string& mode) {
  ExtractOptions options;
  options.keep_topology = true;
  const auto extraction = extract_mode_surface<double>(mesh, ModeValue::parse(mode), options);
  EXPECT_EQ(unresolved_text(extraction), "");
  EXPECT_EQ(flaws(extraction, mesh), "");
  return extraction.topology.faces;
}

// The number of closed curves in faces that the extraction proves.
std::size_t loops_in_faces(const TetMesh& mesh, const std::string& mode) {
  std::size_t loops = 0;
  for (const auto& face : proved_faces(mesh, mode)) loops += face.loops.size();
  return loops;
}

// How often a surface crosses an edge of the mesh.
int crossings_of(const std::array<Index, 2>& edge, const SurfaceMesh& surface) {
  int crossings = 0;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const auto& on = surface.carrier_vertices[i];
    crossings += surface.carrier[i] == Carrier::edge &&
                 std::minmax(on[0], on[1]) == std::minmax(edge[0], edge[1]);
  }
  return crossings;
}

// By the rule mu + 0 there is a small loop around a minimum already, around a maximum none anymore.
TEST(FaceExtremum, HasALoopAroundAMinimumAndNoneAroundAMaximum) {
  Random random(20241213);
  for (int trial = 0; trial < trials(4); ++trial) {
    const TetMesh low = reference_tet_mesh(stratum_tensors(Stratum::face_minimum, random));
    const TetMesh high = reference_tet_mesh(stratum_tensors(Stratum::face_maximum, random));
    EXPECT_EQ(loops_in_faces(low, "-143/343"), loops_in_faces(low, "-0.41690963") + 1);
    EXPECT_EQ(loops_in_faces(low, "-143/343"), loops_in_faces(low, "-0.41690961"));
    EXPECT_EQ(loops_in_faces(high, "143/343") + 1, loops_in_faces(high, "0.41690961"));
    EXPECT_EQ(loops_in_faces(high, "143/343"), loops_in_faces(high, "0.41690963"));
  }
}

// On a face of plane strain the mode depends on r alone: it is -1 at r = 0, 0 at 1, 1 at 3, and
// 0.597 at 8, where the circle touches a side. So all curves are closed up to there: one of each
// level below 0.597, two of each above.
TEST(PlaneStrainFace, HasConcentricLoops) {
  Random random(20241215);
  for (int trial = 0; trial < trials(1); ++trial) {
    TetTensors tensors;
    const double corners[3][2] = {{-16, -8}, {16, -8}, {0, 16}};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [x, y] = corners[i];
      tensors[i] = {1 + x, 1 - x, -2, y, 0, 0};
    }
    tensors[3] = rounded(8.0 * random.tensor(), 0);
    const auto q = random.quaternion();
    for (auto& t : tensors) t = turned(t, q);
    const TetMesh mesh = reference_tet_mesh(tensors);
    for (const auto& [mode, loops] : {std::pair{"-999999/1000000", 1u},
                                      {"-1/2", 1u},
                                      {"0", 1u},
                                      {"6/10", 2u},
                                      {"9/10", 2u},
                                      {"999/1000", 2u},
                                      {"999999/1000000", 2u}}) {
      SCOPED_TRACE(std::string(mode) + '\n' + exact_text(tensors));
      const auto faces = proved_faces(mesh, mode);
      const auto face = std::find_if(faces.begin(), faces.end(), [](const auto& f) {
        return f.vertices == std::array<Index, 3>{0, 1, 2};
      });
      ASSERT_NE(face, faces.end());
      EXPECT_EQ(face->loops.size(), loops);
      EXPECT_TRUE(face->arcs.empty());
    }
  }
}

// Of mode 1 or -1 all along: crossed by no surface, however near, and run along by one curve.
TEST(DegenerateEdge, IsCrossedByNoSurfaceAndRunAlongByOneCurve) {
  Random random(20241214);
  for (int trial = 0; trial < trials(2); ++trial) {
    TetMesh mesh = cube_mesh(1);
    for (auto& t : mesh.tensors) t = rounded(8.0 * random.tensor(), 0);
    const std::array<Index, 2> edge{mesh.tets[0][0], mesh.tets[0][1]};
    const double sign = trial % 2 == 0 ? 1 : -1;
    const auto q = random.quaternion();
    for (const Index v : edge)
      mesh.tensors[static_cast<std::size_t>(v)] =
          turned((sign * random.integer(1, 3)) * SymmetricTensor<double>{2, -1, -1, 0, 0, 0}, q);
    for (const char* mode : {"0", "-1/2", "9/10", "-999/1000", "999/1000", "999999/1000000"}) {
      SCOPED_TRACE("trial " + std::to_string(trial) + " at " + mode);
      const Extraction extraction = extract(mesh, mode);
      EXPECT_EQ(unresolved_text(extraction), "");
      EXPECT_EQ(flaws(extraction, mesh), "");
      EXPECT_EQ(crossings_of(edge, extraction.surface), 0);
    }
    for (const Degeneracy kind : {Degeneracy::linear, Degeneracy::planar}) {
      const auto found = extract_degenerate_curves(mesh, kind);
      const double mode = kind == Degeneracy::linear ? 1 : -1;
      EXPECT_TRUE(found.unresolved.empty());
      EXPECT_EQ(flaws(found, mesh, mode, CurveEnds::free), "");
      int along = 0;
      for (const auto& line : found.curves.lines) {
        const auto end = [&](Index v) {
          const auto& on = found.curves.carrier_vertices[static_cast<std::size_t>(v)];
          return on[1] < 0 ? on[0] : -1;
        };
        along += std::minmax(end(line.front()), end(line.back())) == std::minmax(edge[0], edge[1]);
      }
      EXPECT_EQ(along, mode == sign ? 1 : 0);
    }
  }
}

// The mode on one edge has the largest value 4/5 inside it, or for opposite tensors the least.
TEST(TangentEdge, IsNotCrossedFromBelowAndTwiceFromAbove) {
  for (const double sign : {1.0, -1.0}) {
    TetMesh mesh = cube_mesh(1);
    Random random(20241211);
    for (auto& t : mesh.tensors) t = rounded(8.0 * random.tensor(), 0);
    const std::array<Index, 2> edge{mesh.tets[0][0], mesh.tets[0][1]};
    mesh.tensors[static_cast<std::size_t>(edge[0])] =
        sign * SymmetricTensor<double>{0, 0, 0, 1, 2, 1};
    mesh.tensors[static_cast<std::size_t>(edge[1])] =
        sign * SymmetricTensor<double>{0, 0, 0, 1, 2, 2};
    const Extraction extraction = extract(mesh, sign > 0 ? "4/5" : "-4/5");
    EXPECT_EQ(flaws(extraction, mesh, {}), "");
    EXPECT_TRUE(extraction.unresolved.empty());
    EXPECT_GT(extraction.statistics.tets_nearby, 0u);
    EXPECT_EQ(crossings_of(edge, extraction.surface), sign > 0 ? 0 : 2);
  }
}

// With a common eigenvector the neutral level is straight lines in a face, which may join corners
// of the subdivision: an edge between them is on the level from end to end.
TEST(CommonEigenvector, IsTheSameInAnyNumbering) {
  const std::array<SymmetricTensor<double>, 4> tensors{
      {{1, -1, 1, -1, 0, 0}, {0, 1, -1, -1, 0, 0}, {-1, -1, -1, 1, 0, 0}, {-1, 0, -1, 1, 0, 0}}};
  const auto corners = reference_tet_mesh(tensors).points;
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  std::optional<SurfaceSummary> expected;
  do {
    TetTensors permuted;
    for (std::size_t i = 0; i < 4; ++i) permuted[i] = tensors[order[i]];
    TetMesh mesh = reference_tet_mesh(permuted);
    for (std::size_t i = 0; i < 4; ++i) mesh.points[i] = corners[order[i]];
    const Vector3<double> a = mesh.points[1] - mesh.points[0], b = mesh.points[2] - mesh.points[0],
                          c = mesh.points[3] - mesh.points[0];
    if (dot(cross(a, b), c) < 0) std::swap(mesh.tets[0][2], mesh.tets[0][3]);
    const Extraction extraction = extract(mesh, "0");
    const std::string numbering = "order " + std::to_string(order[0]) + std::to_string(order[1]) +
                                  std::to_string(order[2]) + std::to_string(order[3]);
    EXPECT_EQ(unresolved_text(extraction), "") << numbering;
    if (!expected) expected = summary(extraction.surface);
    EXPECT_EQ(summary(extraction.surface), *expected) << numbering;
  } while (std::next_permutation(order.begin(), order.end()));
}

// Antiplane shear has mode 0 throughout; off by a rounding, only that decides. Samples of a
// boundary loop fall together there, polygons beside them lose their corners, and gradients cancel.
TEST(AntiplaneShear, OffByARoundingIsSound) {
  const TetTensors tensors{
      {{0x1.4p+6, -0x1p+4, -0x1.fffffffffffffp+5, -0x1.fffffffffffffp+4, -0x1.1p+6,
        0x1.6000000000001p+5},
       {0x1.4p+7, -0x1.6p+7, 0x1.0000000000005p+4, 0x1.ffffffffffff6p+2, -0x1.bfffffffffffbp+4,
        -0x1.bffffffffffffp+5},
       {0x1.7ffffffffffffp+5, 0x1.8p+5, -0x1.8p+6, -0x1.7ffffffffffffp+5, -0x1.5p+6, 0x1.5p+6},
       {0x1p+7, -0x1.4p+7, 0x1.0000000000002p+5, 0x1.0000000000005p+4, -0x1.ffffffffffffp+2,
        -0x1p+6}}};
  const TetMesh mesh = reference_tet_mesh(tensors);
  const Extraction extraction = extract(mesh, "0");
  EXPECT_EQ(unresolved_text(extraction), "");
  EXPECT_GT(extraction.surface.triangles.size(), 100u);
  EXPECT_EQ(flaws(extraction, mesh, {.residuals = false, .coincidences = false}), "");
}

}  // namespace
}  // namespace tensortopo::test
