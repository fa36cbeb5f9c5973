// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "analyze/surface/surface_quality.hpp"
#include "analysis/run_program.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/extract/improve_triangles.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo::test {
namespace {

using Index = SurfaceMesh::Index;

/// Directed edges with one triangle in a tetrahedron, with the tetrahedron.
std::set<std::array<Index, 3>> rims_of(const SurfaceMesh& surface) {
  std::set<std::array<Index, 3>> rims;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = surface.triangles[i][k], b = surface.triangles[i][(k + 1) % 3];
      if (rims.erase({surface.tet[i], b, a}) == 0) rims.insert({surface.tet[i], a, b});
    }
  return rims;
}

using Topology = std::tuple<std::size_t, long, long, bool, bool>;

Topology topology_of(const SurfaceMesh& surface) {
  const auto all = surface_invariants(surface);
  return {all.components, all.euler_characteristic, all.boundary_loops, all.manifold,
          all.consistently_oriented};
}

/// Of the sheets in each tetrahedron.
std::map<Index, Topology> sheets_of(const SurfaceMesh& surface) {
  std::map<Index, SurfaceMesh> parts;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    SurfaceMesh& part = parts[surface.tet[i]];
    std::array<Index, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = static_cast<Index>(part.points.size());
      const auto v = surface.triangles[i][k];
      const auto old = std::find(part.carrier_id.begin(), part.carrier_id.end(), v);
      if (old != part.carrier_id.end()) {
        corners[k] = static_cast<Index>(old - part.carrier_id.begin());
      } else {
        part.carrier_id.push_back(v);
        part.points.push_back(surface.points[as_size(v)]);
      }
    }
    part.triangles.push_back(corners);
  }
  std::map<Index, Topology> result;
  for (const auto& [tet, part] : parts) result[tet] = topology_of(part);
  return result;
}

double mean_angle(const SurfaceMesh& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles)
    sum += quality_of({surface.points[as_size(t[0])], surface.points[as_size(t[1])],
                       surface.points[as_size(t[2])]})[0];
  return sum / static_cast<double>(surface.triangles.size());
}

class ImproveTriangles : public testing::TestWithParam<const char*> {};

// Sheets with handles and many loops, at both signs and at 0: topology and rims of each tetrahedron
// stay, and so do vertices on edges; angles get larger on the whole and nowhere less at worst.
TEST_P(ImproveTriangles, KeepsWhatWasProved) {
  const ModeValue mode = ModeValue::parse(GetParam());
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 17);
  const SurfaceMesh before = extract_mode_surface<double>(mesh, mode).surface;
  SurfaceMesh after = before;
  const ImprovementCounts counts = improve_triangles(mesh, mode, after);
  EXPECT_GT(counts.flipped, 10u);  // the extractor has flipped most already
  EXPECT_GT(counts.moved_in_tets, 100u);
  EXPECT_GT(counts.moved_along_faces, 100u);
  EXPECT_EQ(topology_of(before), topology_of(after));
  EXPECT_EQ(sheets_of(before), sheets_of(after));
  EXPECT_EQ(rims_of(before), rims_of(after));
  EXPECT_EQ(before.tet, after.tet);
  EXPECT_NEAR(counts.before.mean, mean_angle(before), 1e-9);
  EXPECT_NEAR(counts.after.mean, mean_angle(after), 1e-9);
  EXPECT_NEAR(counts.before.least, triangle_quality(before).least_angle, 1e-6);
  EXPECT_NEAR(counts.after.least, triangle_quality(after).least_angle, 1e-6);
  EXPECT_GT(mean_angle(after), 1.03 * mean_angle(before));
  EXPECT_GE(triangle_quality(after).least_angle, triangle_quality(before).least_angle * (1 - 1e-9));
  for (std::size_t v = 0; v < before.points.size(); ++v) {
    const auto d = after.points[v] - before.points[v];
    EXPECT_TRUE(before.carrier[v] != Carrier::edge || dot(d, d) == 0);
    EXPECT_LT(std::abs(after.residual[v]), 1e-12);
    EXPECT_NEAR(dot(after.normal[v], after.normal[v]), 1, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, ImproveTriangles, testing::Values("0.5", "-0.5", "0"));

// The independent checker confirms every claim about an improved surface: vertices in their faces
// and tetrahedra, topology, distances.
TEST(ImproveTrianglesProgram, LeavesSurfacesThatAreCertified) {
  const Folder folder;
  const std::string surface = folder / "s.vtp", certificate = folder / "s.json";
  const Outcome run = run_program({"extract", field("s4_slab"), "--mode", "0.5", "--improve", "-o",
                                   surface, "--certify", certificate});
  ASSERT_EQ(run.status, 0) << run.err;
  const Outcome check = run_program({"check", field("s4_slab"), surface, certificate});
  if (check.err.find("built without") != std::string::npos) GTEST_SKIP() << check.err;
  EXPECT_EQ(check.status, 0) << check.out << check.err;
}

TEST(ImproveTrianglesProgram, IsForOurOwnSurfaces) {
  const Folder folder;
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--method", "marching"}, {"--max-error", "1"}}) {
    std::vector<std::string> words{"extract", field("s4_slab"), "--mode",      "0.5",
                                   "-o",      folder / "s.vtp", "--improve"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_program(words).status, 2);
  }
}

}  // namespace
}  // namespace tensortopo::test
