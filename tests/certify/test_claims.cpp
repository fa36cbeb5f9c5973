// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "certify_case.hpp"
#include "extract/level/exact_side.hpp"
#include "support/compared.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo::test {
namespace {

class Claims : public testing::TestWithParam<const char*> {
 protected:
  static constexpr std::uint64_t kSeed = 20241101;

  template <class Check>
  void for_each_case(const Check& check) const {
    for (int trial = 0; trial < trials(3); ++trial) {
      const auto seed = kSeed + static_cast<std::uint64_t>(trial);
      SCOPED_TRACE(std::string("mode ") + GetParam() + ", " + announce(seed));
      TetMesh mesh = cube_mesh(2);
      if (trial % 2 == 0)
        fill_with_normal_tensors(mesh, seed);
      else
        fill_with_smooth_tensors(mesh, seed);
      check(mesh, certified(mesh, GetParam()));
    }
  }
};

bool is_above(const TetMesh& mesh, const LevelTopology::Edge& edge, double t,
              const ModeValue& mode) {
  const std::array tensors{mesh.tensors[as_size(edge.vertices[0])],
                           mesh.tensors[as_size(edge.vertices[1])]};
  const std::array exponents{0, 0};
  const std::array weights{1 - t, t};
  return exact_side_of_level(tensors, exponents, weights, mode) == Sign::positive;
}

TEST(CertifiedLevel, IsMadeOfATopologyThatWasKeptAndOnce) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20261129);
  const ModeValue mode = ModeValue::parse("1/4");
  ExtractOptions options;
  Extraction without = extract_mode_surface<double>(mesh, mode, options);
  ASSERT_FALSE(without.surface.triangles.empty());
  EXPECT_THROW(certify(mesh, mode, without), std::invalid_argument);
  options.keep_topology = true;
  Extraction with = extract_mode_surface<double>(mesh, mode, options);
  EXPECT_GT(certify(mesh, mode, with).claims(), 10u);
  EXPECT_THROW(certify(mesh, mode, with), std::invalid_argument);
}

TEST_P(Claims, BracketsPartTheCrossingsOfAnEdge) {
  for_each_case([](const TetMesh& mesh, const Certified& c) {
    ASSERT_EQ(c.level.brackets.size(), c.level.topology.edges.size());
    for (std::size_t e = 0; e < c.level.brackets.size(); ++e) {
      const auto& edge = c.level.topology.edges[e];
      ASSERT_EQ(c.level.brackets[e].size(), edge.crossings.size());
      double free_from = 0;
      for (std::size_t k = 0; k < edge.crossings.size(); ++k) {
        const auto& bracket = c.level.brackets[e][k];
        const double low = std::ldexp(static_cast<double>(bracket.place), -bracket.depth);
        const double high = std::ldexp(static_cast<double>(bracket.place + 1), -bracket.depth);
        EXPECT_GE(low, free_from);
        EXPECT_LE(high, 1);
        free_from = high;
        const auto& mode = std::get<ModeValue>(c.level.value);
        EXPECT_EQ(is_above(mesh, edge, low, mode), !edge.crossings[k].rising);
        EXPECT_EQ(is_above(mesh, edge, high, mode), edge.crossings[k].rising);
        // The vertex is where the bracket says.
        const auto &p = mesh.points[as_size(edge.vertices[0])],
                   &q = mesh.points[as_size(edge.vertices[1])];
        const auto& x = c.extraction.surface.points[as_size(edge.crossings[k].vertex)];
        const double t = dot(x - p, q - p) / dot(q - p, q - p);
        EXPECT_GT(t, low - 1e-12);
        EXPECT_LT(t, high + 1e-12);
      }
    }
  });
}

TEST_P(Claims, EulerCharacteristicsOfTheSheetsAddUpToThatOfTheSurface) {
  for_each_case([](const TetMesh&, const Certified& c) {
    // Compactly supported: a crossing counts 1, an open arc -1, a closed curve 0, and the inside of
    // a sheet as the sheet.
    std::int64_t sum = 0, claimed = 0;
    for (const auto& edge : c.level.topology.edges)
      sum += static_cast<std::int64_t>(edge.crossings.size());
    for (const auto& face : c.level.topology.faces)
      sum -= static_cast<std::int64_t>(face.arcs.size());
    for (const auto& tet : c.level.topology.tets)
      for (const auto& sheet : tet.sheets) sum += sheet.euler_characteristic;
    for (const auto& component : c.level.components) claimed += component.euler_characteristic;
    EXPECT_EQ(sum, claimed);
    EXPECT_EQ(claimed, surface_invariants(c.extraction.surface).euler_characteristic);
  });
}

/// A face and, of one of its curves, the ends (or the smallest vertex twice).
using CurveKey =
    std::pair<std::array<LevelTopology::Index, 3>, std::array<LevelTopology::Vertex, 2>>;

TEST_P(Claims, SheetsAreBoundedByTheCurvesOfTheirFaces) {
  for_each_case([](const TetMesh& mesh, const Certified& c) {
    std::map<CurveKey, int> used;
    for (const auto& tet : c.level.topology.tets)
      for (const auto& sheet : tet.sheets)
        for (const auto& loop : sheet.loops) {
          for (std::size_t k = 0; k < loop.size(); ++k) {
            std::array<LevelTopology::Index, 3> face{};
            std::size_t n = 0;
            for (const auto v : mesh.tets[as_size(tet.tet)])
              if (v != loop[k].opposite) face[n++] = v;
            ASSERT_EQ(n, 3u);
            std::sort(face.begin(), face.end());
            const auto v = loop[k].from, w = loop[(k + 1) % loop.size()].from;
            ++used[{face, {std::min(v, w), std::max(v, w)}}];
          }
          EXPECT_TRUE(std::all_of(loop.begin(), loop.end(), [&](const auto& arc) {
            return loop[0].from <= arc.from;
          }));
        }
    std::map<std::array<LevelTopology::Index, 3>, int> sides;
    for (auto tet : mesh.tets) {
      std::sort(tet.begin(), tet.end());
      for (std::size_t i = 0; i < 4; ++i)
        ++sides[{tet[i == 0 ? 1 : 0], tet[i < 2 ? 2 : 1], tet[i < 3 ? 3 : 2]}];
    }
    std::map<CurveKey, int> expected;
    for (const auto& face : c.level.topology.faces) {
      for (const auto& arc : face.arcs) expected[{face.vertices, arc}] += sides[face.vertices];
      for (const auto v : face.loops) expected[{face.vertices, {v, v}}] += sides[face.vertices];
    }
    EXPECT_EQ(used, expected);
  });
}

TEST_P(Claims, LoopsRunAsTheTrianglesHaveThem) {
  for_each_case([](const TetMesh&, const Certified& c) {
    // Directed edges at the rim of each tetrahedron's triangles.
    const auto& surface = c.extraction.surface;
    std::map<LevelTopology::Index, std::set<std::array<LevelTopology::Vertex, 2>>> rim;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto v = surface.triangles[i][k], w = surface.triangles[i][(k + 1) % 3];
        if (rim[surface.tet[i]].erase({w, v}) == 0) rim[surface.tet[i]].insert({v, w});
      }
    for (const auto& tet : c.level.topology.tets) {
      std::map<LevelTopology::Vertex, LevelTopology::Vertex> next;
      for (const auto& [v, w] : rim[tet.tet]) next[v] = w;
      for (const auto& sheet : tet.sheets)
        for (const auto& loop : sheet.loops)
          for (std::size_t k = 0; k < loop.size(); ++k) {
            const auto end = loop[(k + 1) % loop.size()].from;
            auto v = loop[k].from;
            std::size_t steps = 0;
            do {
              ASSERT_TRUE(next.contains(v));
              v = next[v];
              ASSERT_LT(++steps, surface.points.size() + 1);
            } while (v != end && surface.carrier[as_size(v)] == Carrier::face);
            EXPECT_EQ(v, end);
          }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Levels, Claims, testing::ValuesIn(kLevels));

/// A mesh with isotropic vertices, and its claims.
Certified with_zero_vertices(TetMesh& mesh, std::uint64_t seed, const std::string& mode) {
  mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, seed);
  // The middle of the cube, and two corners that have an edge with it.
  for (const std::size_t zero : {13u, 0u, 26u}) mesh.tensors[zero] = {3, 3, 3, 0, 0, 0};
  return certified(mesh, mode);
}

TEST(Claims, ConesHaveASheetForEachCurveOfWhatIsOpposite) {
  std::size_t joins = 0;
  for (std::uint64_t seed = 20241105; seed < 20241109; ++seed) {
    TetMesh mesh;
    const auto c = with_zero_vertices(mesh, seed, "1/2");
    EXPECT_TRUE(c.level.undecided.empty());
    std::map<std::vector<LevelTopology::Index>, std::size_t> curves;
    for (const auto& e : c.level.topology.edges)
      curves[{e.vertices.begin(), e.vertices.end()}] = e.crossings.size();
    for (const auto& f : c.level.topology.faces)
      curves[{f.vertices.begin(), f.vertices.end()}] = f.arcs.size() + f.loops.size();
    std::map<LevelTopology::Index, std::size_t> expected, found;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      std::vector<LevelTopology::Index> base;
      for (const auto v : mesh.tets[t])
        if (!(deviator(mesh.tensors[as_size(v)]) == Deviator<double>{})) base.push_back(v);
      std::sort(base.begin(), base.end());
      if (base.size() < 4 && curves.contains(base))
        expected[static_cast<LevelTopology::Index>(t)] = curves[base];
    }
    for (const auto& cone : c.level.topology.cones) {
      found[cone.tet] = cone.sheets.size();
      if (cone.sheets[0].size() == 4) ++joins;
      for (const auto& sheet : cone.sheets)
        EXPECT_EQ(c.extraction.surface.carrier[as_size(sheet.back())], Carrier::vertex);
    }
    EXPECT_EQ(found, expected);
    EXPECT_FALSE(found.empty());
  }
  EXPECT_GT(joins, 0u);
}

TEST(Claims, EulerCharacteristicsAddUpWithConesAsWell) {
  Compared compared("sheets of cones", 4);
  for (std::uint64_t seed = 20241105; seed < 20241109; ++seed) {
    TetMesh mesh;
    const auto c = with_zero_vertices(mesh, seed, "1/4");
    // Compactly supported, and beside what is counted without cones: the lines from crossings to
    // tips, tips at rims, and what lies between two tips.
    std::int64_t sum = 0;
    for (const auto& e : c.level.topology.edges) sum += static_cast<int>(e.crossings.size());
    for (const auto& f : c.level.topology.faces) sum -= static_cast<int>(f.arcs.size());
    for (const auto& tet : c.level.topology.tets)
      for (const auto& sheet : tet.sheets) sum += sheet.euler_characteristic;
    std::set<std::pair<LevelTopology::Vertex, LevelTopology::Vertex>> lines;
    std::set<LevelTopology::Vertex> tips, halfway;
    for (const auto& cone : c.level.topology.cones)
      for (const auto& s : cone.sheets) {
        ++compared;
        ++sum;
        if (s.size() == 2) continue;
        const auto other = s.size() == 3 ? s[1] : s[0];
        lines.insert({{s[0], s.size() == 3 ? s[2] : s[1]}, {other, s.back()}});
        tips.insert({s.size() == 3 ? s[2] : s[1], s.back()});
        if (s.size() == 4) halfway.insert(s[2]);
      }
    sum += static_cast<std::int64_t>(tips.size()) - static_cast<std::int64_t>(lines.size()) -
           static_cast<std::int64_t>(halfway.size());
    EXPECT_EQ(sum, surface_invariants(c.extraction.surface).euler_characteristic);
  }
}

}  // namespace
}  // namespace tensortopo::test
