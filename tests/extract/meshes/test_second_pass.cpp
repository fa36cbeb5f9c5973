// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <utility>

#include "extract/cases/extract_case.hpp"
#include "extract/surface/assemble.hpp"
#include "extract/surface/mesh_around.hpp"
#include "support/fields/special_meshes.hpp"

namespace tensortopo::test {
namespace {

// Vertices of the mesh lie on the level, and where their samples fall together a sheet is pinched
// at them. The extraction then goes on at a level that keeps off those vertices: edges, faces and
// tetrahedra around them are done once more.
TEST(SecondPass, TracesFacesWithMovedEdgesAgain) {
  Random random(33);
  const TetMesh mesh = special_mesh(MeshKind::sparse, random);
  const Extraction extraction = extract(mesh, "1/2");
  ASSERT_GT(extraction.statistics.vertices_on_level, 0u);
  ASSERT_GT(extraction.statistics.tets_nearby, 0u);
  const auto pinched = std::count_if(
      extraction.unresolved.begin(), extraction.unresolved.end(),
      [](const auto& cell) { return cell.reason == UnresolvedReason::inconsistent_samples; });
  EXPECT_EQ(pinched, 0);
  EXPECT_EQ(flaws(extraction, mesh, {.residuals = false, .coincidences = false}), "");
}

void expect_same(const Extraction& p, const Extraction& q) {
  const auto same_points = [](const auto& x, const auto& y) {
    return std::ranges::equal(
        x, y, [](const auto& a, const auto& b) { return a.x == b.x && a.y == b.y && a.z == b.z; });
  };
  EXPECT_TRUE(same_points(p.surface.points, q.surface.points));
  EXPECT_TRUE(same_points(p.surface.medium_eigenvector, q.surface.medium_eigenvector));
  EXPECT_EQ(p.surface.triangles, q.surface.triangles);
  EXPECT_EQ(p.surface.tet, q.surface.tet);
  EXPECT_EQ(p.surface.carrier, q.surface.carrier);
  EXPECT_EQ(p.surface.carrier_id, q.surface.carrier_id);
  EXPECT_EQ(p.surface.component, q.surface.component);
  EXPECT_EQ(p.not_embedded, q.not_embedded);
  EXPECT_TRUE(std::ranges::equal(p.unresolved, q.unresolved, [](const auto& a, const auto& b) {
    return a.tet == b.tet && a.reason == b.reason;
  }));
}

/// A cube of five unit cubes a side (in the short suite of four), with the tensors of a small mesh
/// in a corner and a smooth field elsewhere.
TetMesh with_sparse_corner(std::uint64_t seed) {
  Random random(seed);
  const TetMesh corner = special_mesh(MeshKind::sparse, random);
  TetMesh mesh = cube_mesh(full_or_short(5, 4));
  fill_with_smooth_tensors(mesh, seed);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (std::size_t w = 0; w < corner.points.size(); ++w)
      if (mesh.points[v] == corner.points[w]) mesh.tensors[v] = corner.tensors[w];
  return mesh;
}

// What is done again around vertices is what all tetrahedra done again would give.
TEST(SecondPass, IsTheSameAsAllTetrahedraDoneAgain) {
  const ModeValue mode = ModeValue::parse("1/2");
  std::size_t compared = 0, again = 0, all = 0;
  for (const auto& [seed, dense] : {std::pair{20u, false}, std::pair{33u, true}}) {
    const TetMesh mesh = with_sparse_corner(seed);
    ExtractOptions options;
    for (std::size_t t = 0; dense && t < mesh.tets.size(); ++t)
      options.density.push_back(2 * t < mesh.tets.size() ? 1 : 2);
    const PreparedField<double> prepared(mesh);
    const auto level = make_level<double>(mode);
    NearbyLevels<double> nearby(mode);
    const SurfaceInput<double> input{
        prepared.canonical->mesh, prepared, prepared.field, options, level, nearby};
    VertexSides sides = classify_vertices(input);
    const ActiveCells active = active_cells(input, sides);
    StageSeconds seconds;
    auto here = mesh_level(input, sides, active.complex, seconds);
    for (;;) {
      const auto moved = keep_off_pinched(input, active.complex, here.meshes, sides);
      if (moved.empty()) break;
      again += mesh_around(input, sides, active.complex, moved, here, seconds);
      auto everywhere = mesh_level(input, sides, active.complex, seconds);
      all += active.complex.tets.size();
      ++compared;
      ASSERT_EQ(here.meshes.vertices.round_of_face, everywhere.meshes.vertices.round_of_face);
      for (std::size_t t = 0; t < here.meshes.cells.size(); ++t) {
        const auto &p = here.meshes.cells[t], &q = everywhere.meshes.cells[t];
        EXPECT_EQ(p.mesher, q.mesher);
        EXPECT_EQ(p.unresolved, q.unresolved);
        EXPECT_EQ(p.patch.triangles.size(), q.patch.triangles.size());
      }
      VertexSides later = sides;
      if (!keep_off_pinched(input, active.complex, everywhere.meshes, later).empty()) continue;
      expect_same(assemble(input, sides, active, std::move(here.proofs), std::move(here.meshes)),
                  assemble(input, sides, active, std::move(everywhere.proofs),
                           std::move(everywhere.meshes)));
      break;
    }
  }
  std::cout << compared << " second passes, " << again << " of " << all
            << " tetrahedra done again\n";
  EXPECT_GE(compared, 2u);
  EXPECT_LT(2 * again, all);
}

}  // namespace
}  // namespace tensortopo::test
