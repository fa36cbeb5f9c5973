// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/subdivision_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <numeric>
#include <set>

#include "extract/cases/extract_case.hpp"
#include "mode_of_deviator.hpp"
#include "support/oracles/brute_force.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

constexpr std::size_t kBudget = 400000;

// Components, Euler numbers and loops, counted anew from the polygons.
std::vector<ComponentTopology> recount(const SubdivisionMesh& mesh) {
  std::map<int, ComponentTopology> components;
  std::map<int, std::set<std::uint32_t>> nodes;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& polygon : mesh.polygons) {
    ++components[polygon.component].euler;
    for (int i = 0; i < polygon.size; ++i) {
      const auto p = polygon.nodes[static_cast<std::size_t>(i)],
                 q = polygon.nodes[static_cast<std::size_t>((i + 1) % polygon.size)];
      nodes[polygon.component].insert(p);
      sides[std::minmax(p, q)] = polygon.component;
    }
  }
  for (auto& [c, topology] : components) topology.euler += static_cast<int>(nodes[c].size());
  for (const auto& [side, c] : sides) --components[c].euler;
  for (const auto& [c, topology] : components)
    components[c].loops =
        static_cast<int>(mesh.components[static_cast<std::size_t>(c)].boundary_loops.size());
  std::vector<ComponentTopology> result;
  for (const auto& [c, topology] : components) result.push_back(topology);
  std::sort(result.begin(), result.end());
  return result;
}

// "" if the mesh is an oriented surface whose free sides are the boundary loops, on faces.
std::string flaws_of(const SubdivisionMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& polygon : mesh.polygons)
    for (int i = 0; i < polygon.size; ++i)
      if (++sides[{polygon.nodes[static_cast<std::size_t>(i)],
                   polygon.nodes[static_cast<std::size_t>((i + 1) % polygon.size)]}] > 1)
        return "two polygons run along one side the same way";
  std::map<std::uint32_t, std::uint32_t> boundary;
  for (const auto& [side, count] : sides) {
    if (sides.contains({side.second, side.first})) continue;
    if ((mesh.nodes[side.first].faces & mesh.nodes[side.second].faces) == 0)
      return "a free side inside the tetrahedron";
    if (!boundary.emplace(side.first, side.second).second) return "a boundary that branches";
  }
  for (const auto& loop : mesh.boundary_loops) {
    if (loop.size() < 3) return "a boundary loop of fewer than three nodes";
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto found = boundary.find(loop[i]);
      if (found == boundary.end() || found->second != loop[(i + 1) % loop.size()])
        return "a boundary loop that is no boundary";
      boundary.erase(found);
    }
  }
  return boundary.empty() ? "" : "a boundary that is in no loop";
}

TEST(SubdivisionMesh, IsAnOrientedSurfaceWithTheTopologyThatBruteForceSees) {
  const std::uint64_t seed = 20240701;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int decided = 0;
  const int count = trials(120);
  for (int trial = 0; trial < count; ++trial) {
    const TetTensors tensors = random.tet_tensors();
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % 8]);
    SCOPED_TRACE("mode " + mode.text() + '\n' + exact_text(tensors));
    const SimplexCase<double, 4> tet(tensors, mode);
    Refinement<double, 4> refinement(tet.simplex, tet.level);
    ASSERT_TRUE(refinement.run(kBudget));
    const SubdivisionMesh mesh = subdivision_mesh(refinement);
    EXPECT_EQ(flaws_of(mesh), "");
    std::vector<ComponentTopology> stated;
    for (const auto& component : mesh.components)
      stated.push_back(
          {component.euler_characteristic, static_cast<int>(component.boundary_loops.size())});
    std::sort(stated.begin(), stated.end());
    EXPECT_EQ(stated, recount(mesh));
    const auto expected = brute_force_topology(corners_of(tensors), mode.approx());
    if (!expected) continue;
    ++decided;
    EXPECT_EQ(stated, expected->components);
  }
  std::cout << "brute force decided " << decided << " of " << count << '\n';
  EXPECT_GT(10 * decided, 8 * count);
}

// The field at homogeneous weights, from the input's own bits.
Deviator<Real50> exact_tensor(const SimplexCase<double, 4>& tet,
                              const std::array<double, 4>& weights) {
  std::array<Deviator<Real50>, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto wide = tensor_cast<Real50>(tet.mesh.tensors[i]);
    corners[i] = Real50(std::ldexp(1.0, tet.simplex.exponents[i])) * deviator(wide);
  }
  return tensor_at(corners, weights);
}

// Cells fill the tetrahedron without overlap, meet in whole faces, and keep its orientation.
TEST(Refinement, IsAConformingSubdivision) {
  const std::uint64_t seed = 20240702;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (int trial = 0; trial < trials(20); ++trial) {
    const SimplexCase<double, 4> tet(random.tet_tensors(), ModeValue::parse("-9/10"));
    Refinement<double, 4> refinement(tet.simplex, tet.level);
    ASSERT_TRUE(refinement.run(kBudget));
    double volume = 0;
    std::map<std::array<std::uint32_t, 3>, int> faces;
    for (const auto& cell : refinement.cells()) {
      if (!cell.alive) continue;
      const auto point = [&](std::size_t i) {
        const auto& w = refinement.vertices()[cell.vertices[i]].weights;
        return (1 / (w[0] + w[1] + w[2] + w[3])) * Vector3<double>{w[1], w[2], w[3]};
      };
      const auto o = point(0);
      const double own = dot(point(1) - o, cross(point(2) - o, point(3) - o));
      EXPECT_GT(own, 0);
      volume += own;
      for (std::size_t omitted = 0; omitted < 4; ++omitted) {
        std::array<std::uint32_t, 3> face{};
        for (std::size_t i = 0, k = 0; i < 4; ++i)
          if (i != omitted) face[k++] = cell.vertices[i];
        std::sort(face.begin(), face.end());
        ++faces[face];
      }
    }
    EXPECT_NEAR(volume, 1, 1e-9);
    for (const auto& [face, count] : faces) {
      bool outer = false;
      for (std::size_t f = 0; f < 4; ++f)
        outer = outer || std::all_of(face.begin(), face.end(), [&](std::uint32_t v) {
                  return refinement.vertices()[v].weights[f] == 0;
                });
      EXPECT_EQ(count, outer ? 1 : 2);
    }
    for (const auto& v : refinement.vertices()) {
      EXPECT_GE(norm_form(v.tensor), 2.99);
      EXPECT_LE(norm_form(v.tensor), 12.01);
      const auto exact = exact_tensor(tet, v.weights);
      const double total = std::accumulate(v.weights.begin(), v.weights.end(), 0.0);
      EXPECT_LT(abs(exact.a - v.tensor.a), 1e-15 * total);
      EXPECT_LT(abs(exact.yz - v.tensor.yz), 1e-15 * total);
    }
  }
}

// An edge that enters the level and leaves it again is cut inside, and then has a crossing on each
// side of the cut.
TEST(Refinement, CutsEdgesBetweenTheirCrossings) {
  const std::uint64_t seed = 20240704;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int compared = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    const auto mode = ModeValue::parse(trial % 2 == 0 ? "9/10" : "-9/10");
    const SimplexCase<double, 4> tet(random.tet_tensors(), mode);
    Refinement<double, 4> refinement(tet.simplex, tet.level);
    ASSERT_TRUE(refinement.run(kBudget));
    const Real50 mu = to_scalar<Real50>(mode);
    const auto& vertices = refinement.vertices();
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const bool side = vertices[i].above;
        const auto is_on_other_side = [&](double share) {
          std::array<double, 4> weights{};
          weights[i] = share, weights[j] = 1 - share;
          return (mode_of_deviator(exact_tensor(tet, weights)) > mu) != side;
        };
        if (vertices[j].above != side || !is_on_other_side(15.0 / 32) || !is_on_other_side(0.5))
          continue;
        const auto first = std::find_if(vertices.begin() + 4, vertices.end(), [&](const auto& v) {
          return v.weights[i] > 0 && v.weights[j] > 0 &&
                 std::count(v.weights.begin(), v.weights.end(), 0.0) == 2;
        });
        ASSERT_NE(first, vertices.end());
        EXPECT_NE(first->above, side) << "trial " << trial;
        ++compared;
      }
  }
  EXPECT_GT(compared, trials(30));
}

// Cells inherit what is proved of the cells that they are cut from; it must hold of them.
TEST(Refinement, ProofsOfItsCellsHold) {
  const std::uint64_t seed = 20240703;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int monotone = 0, empty = 0;
  for (int trial = 0; trial < trials(60); ++trial) {
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const SimplexCase<double, 4> tet(random.tet_tensors(), mode);
    Refinement<double, 4> refinement(tet.simplex, tet.level);
    ASSERT_TRUE(refinement.run(kBudget));
    const Real50 mu = to_scalar<Real50>(mode);
    for (const auto& cell : refinement.cells()) {
      if (!cell.alive) continue;
      std::array<Deviator<Real50>, 4> corners;
      for (std::size_t i = 0; i < 4; ++i)
        corners[i] = exact_tensor(tet, refinement.vertices()[cell.vertices[i]].weights);
      std::array<Real50, 4> from, to;
      for (auto& w : from) w = Real50(random.uniform());
      const Real50 value = mode_of_deviator(tensor_at(corners, from));
      using Kind = SimplexProof<double, 4>::Kind;
      ASSERT_NE(cell.proof.kind, Kind::none);
      if (cell.proof.kind == Kind::empty) {
        ++empty;
        for (const auto v : cell.vertices)
          ASSERT_EQ(refinement.vertices()[v].above, value > mu) << "trial " << trial;
        continue;
      }
      ++monotone;
      Real50 longest(1e9);
      for (std::size_t i = 0; i < 4; ++i)
        if (cell.proof.direction[i] < 0)
          longest = std::min(longest, Real50(-from[i] / Real50(cell.proof.direction[i])));
      const Real50 step = longest * Real50(random.uniform());
      for (std::size_t i = 0; i < 4; ++i) to[i] = from[i] + step * Real50(cell.proof.direction[i]);
      // The line crosses the level upwards only.
      if (value > mu) {
        ASSERT_GT(mode_of_deviator(tensor_at(corners, to)), mu) << "trial " << trial;
      }
    }
  }
  std::cout << monotone << " monotone cells, " << empty << " empty ones\n";
  EXPECT_GT(monotone, 500);
  EXPECT_GT(empty, 50);
}

}  // namespace
}  // namespace tensortopo::test
