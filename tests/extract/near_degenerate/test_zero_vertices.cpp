// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "extract/cases/extract_case.hpp"
#include "support/oracles/brute_force.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;
using Tensor = SymmetricTensor<double>;

constexpr Tensor kNoDeviator{7, 7, 7, 0, 0, 0};

bool holds(const TetMesh& mesh, Index tet, Index vertex) {
  const auto& corners = mesh.tets[static_cast<std::size_t>(tet)];
  return std::find(corners.begin(), corners.end(), vertex) != corners.end();
}

// The mode is constant on rays from the vertex: a disc for each curve of the opposite face.
TEST(ZeroVertex, OneGivesAConeOverEachCurveOfTheOppositeFace) {
  const std::uint64_t seed = 20241101;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int sheets = 0, loops = 0;
  for (int trial = 0; trial < trials(120, 60); ++trial) {
    const char* mode = kLevels[static_cast<std::size_t>(trial) % kLevels.size()];
    TetTensors tensors = random.tet_tensors();
    const auto zero = static_cast<std::size_t>(trial) % 4;
    tensors[zero] = kNoDeviator;
    const TetMesh mesh = reference_tet_mesh(tensors);
    const Extraction extraction = extract(mesh, mode);
    SCOPED_TRACE(std::string(mode) + '\n' + exact_text(tensors));
    EXPECT_EQ(unresolved_text(extraction), "");
    EXPECT_EQ(flaws(extraction, mesh), "");
    EXPECT_EQ(extraction.statistics.zero_deviator_vertices, 1u);
    std::array<Tensor, 3> face;
    for (std::size_t i = 0, k = 0; i < 4; ++i)
      if (i != zero) face[k++] = tensors[i];
    const auto seen = brute_force_face_topology(corners_of(face), ModeValue::parse(mode).approx());
    if (!seen) continue;
    const auto expected = static_cast<std::size_t>(seen->open_arcs + seen->closed_loops);
    const LocalTopology found = topology_in_tet(extraction);
    EXPECT_EQ(found.components, std::vector<ComponentTopology>(expected, disc));
    EXPECT_EQ(found.crossings(),
              std::accumulate(seen->edge_crossings.begin(), seen->edge_crossings.end(), 0));
    EXPECT_EQ(extraction.statistics.cone_points, expected);
    EXPECT_EQ(extraction.statistics.sheets_cones, expected);
    for (const auto& triangle : extraction.surface.triangles)
      EXPECT_EQ(std::count_if(triangle.begin(), triangle.end(),
                              [&](Index v) {
                                return extraction.surface.carrier[static_cast<std::size_t>(v)] ==
                                       Carrier::vertex;
                              }),
                1);
    sheets += static_cast<int>(expected), loops += seen->closed_loops;
  }
  EXPECT_GT(sheets, 50);
  EXPECT_GT(loops, 0);
}

TEST(ZeroVertex, TwoGiveAFlatSheetForEachCrossingOfTheOppositeEdge) {
  const std::uint64_t seed = 20241102;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int sheets = 0;
  for (int trial = 0; trial < trials(240); ++trial) {
    const char* mode = kLevels[static_cast<std::size_t>(trial) % kLevels.size()];
    TetTensors tensors = random.tet_tensors();
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    for (int turn = trial % 24; turn > 0; --turn) std::next_permutation(order.begin(), order.end());
    tensors[order[0]] = tensors[order[1]] = kNoDeviator;
    const TetMesh mesh = reference_tet_mesh(tensors);
    const Extraction extraction = extract(mesh, mode);
    SCOPED_TRACE(std::string(mode) + '\n' + exact_text(tensors));
    EXPECT_EQ(unresolved_text(extraction), "");
    EXPECT_EQ(flaws(extraction, mesh), "");
    const auto crossings = static_cast<std::size_t>(topology_in_tet(extraction).crossings());
    // Two triangles for each, and one disc for each stretch of larger modes.
    EXPECT_EQ(extraction.surface.triangles.size(), 2 * crossings);
    EXPECT_EQ(extraction.statistics.sheets_cones, crossings);
    const auto components = summary(extraction.surface).components;
    EXPECT_EQ(components, std::vector<ComponentTopology>(components.size(), disc));
    EXPECT_GE(2 * components.size(), crossings);
    EXPECT_LE(2 * components.size(), crossings + 2);
    sheets += static_cast<int>(crossings);
  }
  EXPECT_GT(sheets, 30);
}

TEST(ZeroVertex, ThreeLeaveAConstantModeAndFourNone) {
  Random random(20241103);
  for (const char* mode : kLevels) {
    TetTensors tensors = random.tet_tensors();
    tensors[0] = tensors[1] = tensors[3] = kNoDeviator;
    const Extraction three = extract(reference_tet_mesh(tensors), mode);
    EXPECT_EQ(unresolved_text(three), "");
    EXPECT_TRUE(three.surface.triangles.empty());
    EXPECT_EQ(three.statistics.tets_undefined, 0u);
    tensors[2] = kNoDeviator;
    const Extraction four = extract(reference_tet_mesh(tensors), mode);
    EXPECT_EQ(unresolved_text(four), "");
    EXPECT_TRUE(four.surface.triangles.empty());
    EXPECT_EQ(four.statistics.tets_undefined, 1u);
    EXPECT_EQ(four.statistics.zero_deviator_vertices, 4u);
  }
}

// A mode exactly mu counts as below, so a constant one gives nothing.
TEST(ZeroVertex, ThreeAndAVertexOnTheLevelGiveNothing) {
  const Tensor on{11, 2, -13, 0, 0, 0};
  const Extraction extraction =
      extract(reference_tet_mesh({kNoDeviator, on, kNoDeviator, kNoDeviator}), "-143/343");
  EXPECT_EQ(unresolved_text(extraction), "");
  EXPECT_TRUE(extraction.surface.triangles.empty());
  EXPECT_EQ(extraction.statistics.vertices_on_level, 1u);
}

// In a mesh: nothing is torn, and what does not touch the vertex is as it was.
TEST(ZeroVertex, ChangesNothingBeyondItsTetrahedra) {
  const std::uint64_t seed = 20241001;
  SCOPED_TRACE(announce(seed));
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, seed);
  constexpr Index centre = 13;
  TetMesh with_zero = mesh;
  with_zero.tensors[centre] = kNoDeviator;
  for (const char* mode : kLevels) {
    SCOPED_TRACE(mode);
    const Extraction extraction = extract(with_zero, mode), whole = extract(mesh, mode);
    EXPECT_EQ(unresolved_text(extraction), "");
    EXPECT_EQ(flaws(extraction, with_zero), "");
    EXPECT_GT(extraction.statistics.tets_coned, 0u);
    // Tetrahedra crossed, and the same crossings to the last bit.
    const auto elsewhere = [&](const SurfaceMesh& surface) {
      std::set<Index> tets;
      for (const Index t : surface.tet)
        if (!holds(mesh, t, centre)) tets.insert(t);
      std::multiset<std::array<double, 3>> crossings;
      for (std::size_t v = 0; v < surface.points.size(); ++v) {
        const auto& key = surface.carrier_vertices[v];
        const auto& p = surface.points[v];
        if (surface.carrier[v] == Carrier::edge &&
            std::find(key.begin(), key.end(), centre) == key.end())
          crossings.insert({p.x, p.y, p.z});
      }
      return std::pair(tets, crossings);
    };
    EXPECT_EQ(elsewhere(extraction.surface), elsewhere(whole.surface));
  }
}

// Zeros one by one, in rows, in blocks: closed but at the boundary, and a manifold.
TEST(ZeroVertex, AnyNumberOfThemInAMeshGivesAFlawlessSurface) {
  const std::uint64_t seed = 20241104;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (int trial = 0; trial < trials(30); ++trial) {
    TetMesh mesh = cube_mesh(2 + trial % 2);
    if (trial % 3 == 0)
      fill_with_smooth_tensors(mesh, seed + static_cast<std::uint64_t>(trial));
    else
      fill_with_normal_tensors(mesh, seed + static_cast<std::uint64_t>(trial));
    const int percent = std::array{5, 15, 30, 50, 80}[static_cast<std::size_t>(trial) % 5];
    std::size_t zeros = 0;
    for (auto& t : mesh.tensors)
      if (random.integer(0, 99) < percent) t = kNoDeviator, ++zeros;
    const char* mode = kLevels[static_cast<std::size_t>(trial) % 8];
    SCOPED_TRACE("trial " + std::to_string(trial) + " at " + mode);
    const Extraction extraction = extract(mesh, mode);
    EXPECT_EQ(unresolved_text(extraction), "");
    EXPECT_EQ(flaws(extraction, mesh), "");
    EXPECT_EQ(extraction.statistics.zero_deviator_vertices, zeros);
    const SurfaceInvariants known = surface_invariants(extraction.surface);
    EXPECT_TRUE(known.manifold);
    EXPECT_TRUE(known.consistently_oriented);
    const auto& s = extraction.statistics;
    EXPECT_EQ(s.tets_crossed, s.tets_monotone + s.tets_refined + s.tets_coned);
  }
}

// Two neighbours in the middle of a block: sheets go on through the edge between them.
TEST(ZeroVertex, NoSurfaceEndsAtAnEdgeBetweenTwoOfThemInside) {
  const std::uint64_t seed = 20241105;
  SCOPED_TRACE(announce(seed));
  int joined = 0;
  for (int trial = 0; trial < trials(6, 3); ++trial) {
    TetMesh mesh = cube_mesh(3);
    fill_with_normal_tensors(mesh, seed + static_cast<std::uint64_t>(trial));
    const Index first = 21,
                second = std::array{22, 25, 26, 37, 38, 42}[static_cast<std::size_t>(trial) % 6];
    mesh.tensors[first] = mesh.tensors[static_cast<std::size_t>(second)] = kNoDeviator;
    const auto modes =
        trial % 2 == 0 ? std::array{"0", "1/10"} : std::array{"-1/2", "9/10"};
    for (const char* mode : modes) {
      SCOPED_TRACE("trial " + std::to_string(trial) + " at " + mode);
      const Extraction extraction = extract(mesh, mode);
      EXPECT_EQ(flaws(extraction, mesh), "");
      const SurfaceMesh& surface = extraction.surface;
      // Halfway vertices are inner vertices: each has four triangles.
      std::map<Index, int> triangles_at;
      for (const auto& triangle : surface.triangles)
        for (const Index v : triangle) ++triangles_at[v];
      for (const auto& [v, count] : triangles_at)
        if (surface.carrier_vertices[static_cast<std::size_t>(v)] ==
            std::array<Index, 4>{first, second, -1, -1}) {
          EXPECT_EQ(count, 4);
          ++joined;
        }
    }
  }
  EXPECT_GT(joined, 10);
}

// Components, crossings and fans do not depend on frame, units, or numbering.
TEST(ZeroVertex, TopologyIsInvariant) {
  const std::uint64_t seed = 20241106;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (int trial = 0; trial < trials(6); ++trial) {
    TetMesh mesh = cube_mesh(2);
    fill_with_normal_tensors(mesh, seed + static_cast<std::uint64_t>(trial));
    for (auto& t : mesh.tensors) {
      t = rounded(t, 16);
      if (random.integer(0, 99) < 30) t = {};
    }
    const char* mode = std::array{"0", "1/10", "-1/2", "9/10"}[static_cast<std::size_t>(trial) % 4];
    SCOPED_TRACE("trial " + std::to_string(trial) + " at " + mode);
    const Extraction before = extract(mesh, mode);
    const auto expect_same = [&](const TetMesh& other) {
      const Extraction after = extract(other, mode);
      EXPECT_EQ(unresolved_text(after), "");
      EXPECT_EQ(summary(after.surface), summary(before.surface));
      EXPECT_EQ(after.statistics.cone_points, before.statistics.cone_points);
      EXPECT_EQ(flaws(after, other), "");
    };
    TetMesh scaled = mesh;
    for (auto& t : scaled.tensors) t = std::ldexp(1.0, random.integer(-3, 3)) * t;
    expect_same(scaled);
    TetMesh turned = mesh;
    for (auto& t : turned.tensors) t = {t.yy, t.zz, t.xx, -t.yz, -t.xz, t.xy};
    expect_same(turned);
    TetMesh numbered = mesh;
    std::vector<Index> to(mesh.points.size());
    std::iota(to.begin(), to.end(), 0);
    for (std::size_t i = to.size() - 1; i > 0; --i)
      std::swap(to[i], to[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
    for (std::size_t i = 0; i < to.size(); ++i) {
      numbered.points[static_cast<std::size_t>(to[i])] = mesh.points[i];
      numbered.tensors[static_cast<std::size_t>(to[i])] = mesh.tensors[i];
    }
    for (auto& tet : numbered.tets) {
      for (auto& v : tet) v = to[static_cast<std::size_t>(v)];
      std::rotate(tet.begin(), tet.begin() + 1, tet.begin() + 3);
    }
    expect_same(numbered);
  }
}

// The scale of a tensor that vanishes is no scale: tiny tensors around it count as they are.
TEST(ZeroVertex, MagnitudesAroundItDoNotMatter) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20241107);
  for (auto& t : mesh.tensors) t = rounded(t, 8);
  mesh.tensors[13] = {};
  for (const int exponent : {-1000, 900}) {
    TetMesh other = mesh;
    for (auto& t : other.tensors) t = std::ldexp(1.0, exponent) * t;
    const Extraction before = extract(mesh, "1/2"), after = extract(other, "1/2");
    EXPECT_EQ(after.surface.triangles, before.surface.triangles);
    ASSERT_EQ(after.surface.points.size(), before.surface.points.size());
    for (std::size_t v = 0; v < after.surface.points.size(); ++v)
      EXPECT_NEAR(dot(after.surface.normal[v], before.surface.normal[v]), 1, 1e-6);
  }
}

}  // namespace
}  // namespace tensortopo::test
