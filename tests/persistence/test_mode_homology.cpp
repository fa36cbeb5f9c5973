// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "sampled_homology.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/fields/special_meshes.hpp"
#include "tensortopo/persistence/mode_homology.hpp"

namespace tensortopo::test {
namespace {

/// Cubes left out of a mesh of n * n * n cubes.
enum class Hole { none, column, middle };

TetMesh cubes(int n, Hole hole) {
  TetMesh mesh = cube_mesh(n);
  std::erase_if(mesh.tets, [&](const auto& tet) {
    Vector3<double> centre{};
    for (const auto v : tet) centre += 0.25 * mesh.points[as_size(v)];
    const auto is_middle = [&](double x) { return std::abs(x - n / 2.0) < 0.5; };
    const bool in_column = is_middle(centre.x) && is_middle(centre.y);
    return hole == Hole::column ? in_column
                                : hole == Hole::middle && in_column && is_middle(centre.z);
  });
  mesh.cell_ids.resize(mesh.tets.size());
  return mesh;
}

/// Noise around a neutral tensor, so that the deviator is small nowhere.
TetMesh strong_field(TetMesh mesh, std::uint64_t seed, double noise = 0.7) {
  fill_with_normal_tensors(mesh, seed);
  for (auto& tensor : mesh.tensors)
    tensor = noise * tensor + SymmetricTensor<double>{2.5, 0, -2.5, 0, 0, 0};
  return mesh;
}

double angle(double mode) { return signed_lode_angle(mode); }

/// Pairs of a dimension, in signed Lode angles, turned so that they fall.
std::vector<SampledPair> pairs_of(const ModeHomology& found, int dimension, PairKind kind) {
  std::vector<SampledPair> pairs;
  const double sign = kind == PairKind::sublevel ? -1 : 1;
  for (const PersistencePair& p : found.pairs)
    if (p.dimension == dimension && p.kind == kind)
      pairs.push_back(
          {sign * angle(p.birth.middle()), p.is_lasting ? -2 : sign * angle(p.death.middle())});
  return pairs;
}

bool all_loops_are_paired(const ModeHomology& found, PairKind kind) {
  return std::all_of(found.loops.begin(), found.loops.end(), [&](const LoopEvent& event) {
    return event.kind != kind || event.paired == event.count;
  });
}

/// By dimension.
using Counts = std::array<std::size_t, 3>;

struct Comparison {
  Counts betti{}, ranks{};
  std::size_t all_loops = 0;
};

/// The sets {mode >= m}, or {mode <= m}, against those of the sampled function. Functions that
/// differ by e at most are interleaved: what goes from a to b in one does so from a + e to b - e in
/// the other.
void compare(const TetMesh& mesh, const ModeHomology& found, int cuts, PairKind kind,
             Comparison& comparison) {
  const bool is_opposite = kind == PairKind::sublevel;
  const SampledHomology sampled = sampled_homology(mesh, cuts, is_opposite);
  const double e = sampled.error, sign = is_opposite ? -1 : 1;
  for (const BettiInterval& interval : found.betti[is_opposite ? 1 : 0]) {
    const double low = angle(interval.low), high = angle(interval.high);
    if (high - low <= 4 * e) continue;
    const double middle = sign * (low + high) / 2;
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_TRUE(interval.betti[k].has_value());
      EXPECT_EQ(*interval.betti[k], rank_between(sampled.pairs[k], middle + e, middle - e))
          << k << " at " << middle;
      comparison.betti[k] += *interval.betti[k] > 0;
    }
  }
  const bool has_all_loops = all_loops_are_paired(found, kind);
  comparison.all_loops += has_all_loops;
  for (int k = 1; k < 3; ++k) {
    const auto exact = pairs_of(found, k, kind);
    for (double a = -0.5; a < 0.53; a += 0.02)
      for (double b = -0.52; b < a; b += 0.02) {
        const int rank = rank_between(sampled.pairs[static_cast<std::size_t>(k)], a, b);
        EXPECT_GE(rank, rank_between(exact, a + e, b - e)) << k << ": " << a << ' ' << b;
        comparison.ranks[static_cast<std::size_t>(k)] += rank_between(exact, a + e, b - e) > 0;
        if (a - e > b + e && (k == 2 || has_all_loops)) {
          EXPECT_LE(rank, rank_between(exact, a - e, b + e)) << k << ": " << a << ' ' << b;
        }
      }
  }
}

ModeHomology compare(const TetMesh& mesh, int cuts, PairKind kind, Comparison& comparison) {
  const ModeHomology found = mode_homology(mesh, persistence_input(mesh));
  compare(mesh, found, cuts, kind, comparison);
  return found;
}

/// A smooth field around a neutral tensor.
TetMesh smooth_field(TetMesh mesh, std::uint64_t seed, double noise, double shortest) {
  fill_with_smooth_tensors(mesh, seed, 3, shortest);
  for (auto& tensor : mesh.tensors)
    tensor = noise * tensor + SymmetricTensor<double>{2.5, 0, -2.5, 0, 0, 0};
  return mesh;
}

// Another computation that shares nothing with the library's but the mode.
TEST(ModeHomology, AgreesWithBruteForceWithinItsError) {
  Comparison comparison;
  for (const PairKind kind : {PairKind::superlevel, PairKind::sublevel}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      compare(strong_field(cube_mesh(1), seed), 3, kind, comparison);
    for (std::uint64_t seed = 1; seed <= 2; ++seed)
      for (const Hole hole : {Hole::none, Hole::column, Hole::middle})
        compare(smooth_field(cubes(3, hole), seed, 0.3, 2.5), 2, kind, comparison);
  }
  const Counts least{30, 6, 3};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_GE(comparison.betti[k], least[k]) << k;
  EXPECT_GE(comparison.ranks[2], 500u);
  EXPECT_GE(comparison.all_loops, 6u);
}

/// A field whose mode is largest on a circle, or on a sphere.
TetMesh field_around(int n, bool is_sphere, std::uint64_t seed) {
  TetMesh mesh = cube_mesh(n);
  fill_with_normal_tensors(mesh, seed);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vector3<double> x = mesh.points[v] - Vector3<double>{n / 2.0, n / 2.0, n / 2.0};
    const double r = std::sqrt(x.x * x.x + x.y * x.y + (is_sphere ? x.z * x.z : 0)) - 0.31 * n;
    const double distance = r * r + (is_sphere ? 0 : x.z * x.z);
    const double s = std::exp(-distance / (0.05 * n * n));
    mesh.tensors[v] = 0.01 * mesh.tensors[v] + s * SymmetricTensor<double>{2, -1, -1, 0, 0, 0} +
                      (1 - s) * SymmetricTensor<double>{1, 0, -1, 0, 0, 0};
  }
  return mesh;
}

// The ring's loop dies where its hole is filled, the shell's void where its inside is.
TEST(ModeHomology, RingAndShell) {
  for (const bool is_sphere : {false, true}) {
    const TetMesh mesh = field_around(6, is_sphere, 1);
    Comparison comparison;
    const ModeHomology found = compare(mesh, 1, PairKind::superlevel, comparison);
    int long_ones = 0;
    for (const PersistencePair& pair : found.pairs) {
      if (pair.kind != PairKind::superlevel || angle_persistence(pair) < 0.2) continue;
      EXPECT_EQ(pair.dimension, is_sphere ? 2 : 1);
      EXPECT_TRUE(pair.is_certain && !pair.is_tie);
      ++long_ones;
    }
    EXPECT_EQ(long_ones, 1);
    EXPECT_GE(comparison.ranks[is_sphere ? 2 : 1], 30u);
  }
}

// Nothing is left open on noise, and the changes add up to the Betti numbers of the mesh.
TEST(ModeHomology, IsProvedOnNoise) {
  Compared meshes("meshes", 30), lasting("voids of the mesh", 8), voids("voids", 100),
      loops("pairs of loops", 60);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Hole hole = seed % 4 == 0 ? Hole::column : seed % 4 == 1 ? Hole::middle : Hole::none;
    TetMesh mesh = hole == Hole::none ? cube_mesh(1 + static_cast<int>(seed % 2)) : cubes(3, hole);
    fill_with_normal_tensors(mesh, seed);
    const PersistenceInput input = persistence_input(mesh);
    const ModeHomology found = mode_homology(mesh, input);
    const ModePersistence components = mode_persistence(mesh, input);
    EXPECT_EQ(found.mesh_betti,
              (std::array<long, 3>{1, hole == Hole::column, hole == Hole::middle}));
    // A path that is not found leaves its point open.
    if (found.not_proved[0] + found.not_proved[1] > 0 || !components.not_proved[0].empty() ||
        !components.not_proved[1].empty())
      continue;
    ++meshes;
    EXPECT_TRUE(found.has_known_curves);
    EXPECT_TRUE(found.adds_up[0] && found.adds_up[1]) << seed;
    for (const auto& side : found.betti)
      for (const BettiInterval& interval : side)
        for (std::size_t k = 0; k < 3; ++k) {
          ASSERT_TRUE(interval.betti[k].has_value());
          EXPECT_GE(*interval.betti[k], 0);
        }
    for (const PersistencePair& pair : found.pairs) {
      EXPECT_TRUE(pair.is_certain);
      const double sign = pair.kind == PairKind::superlevel ? 1 : -1;
      EXPECT_GE(sign * (pair.birth.middle() - pair.death.middle()), 0);
      lasting.count(pair.is_lasting);
      voids.count(pair.dimension == 2);
      loops.count(pair.dimension == 1);
    }
    for (const LoopEvent& event : found.loops) EXPECT_LE(event.paired, event.count);
  }
}

// Nothing in one part of a mesh meets what is in the other: the numbers are sums.
TEST(ModeHomology, PartsAreApart) {
  TetMesh both = cubes(3, Hole::middle);
  fill_with_normal_tensors(both, 1);
  TetMesh other = cube_mesh(2);
  fill_with_normal_tensors(other, 2);
  std::array<std::size_t, 3> pairs{};
  for (const TetMesh* mesh : {&both, &other})
    for (const PersistencePair& pair : mode_homology(*mesh, persistence_input(*mesh)).pairs)
      ++pairs[static_cast<std::size_t>(pair.dimension)];
  const auto shift = static_cast<TetMesh::Index>(both.points.size());
  for (const auto& x : other.points) both.points.push_back(x + Vector3<double>{10, 0, 0});
  both.tensors.insert(both.tensors.end(), other.tensors.begin(), other.tensors.end());
  for (auto tet : other.tets) {
    for (auto& v : tet) v += shift;
    both.tets.push_back(tet);
  }
  both.cell_ids.resize(both.tets.size());
  const ModeHomology found = mode_homology(both, persistence_input(both));
  EXPECT_EQ(found.mesh_betti, (std::array<long, 3>{2, 0, 1}));
  EXPECT_TRUE(found.adds_up[0] && found.adds_up[1]);
  std::array<std::size_t, 3> sums{};
  for (const PersistencePair& pair : found.pairs) ++sums[static_cast<std::size_t>(pair.dimension)];
  EXPECT_EQ(sums, pairs);
  EXPECT_GT(sums[1], 0u);
  EXPECT_GT(sums[2], 5u);
}

// Tensors in special position: where all is proved, it adds up.
TEST(ModeHomology, AddsUpOnSpecialMeshes) {
  Compared compared("meshes without anything open", 5);
  Random random(1);
  for (int trial = 0; trial < 80; ++trial)
    for (const MeshKind kind : {MeshKind::small_integers, MeshKind::special_tensors}) {
      const TetMesh mesh = special_mesh(kind, random);
      if (mesh.tets.size() > 12) continue;
      const PersistenceInput input = persistence_input(mesh);
      const ModeHomology found = mode_homology(mesh, input);
      const ModePersistence components = mode_persistence(mesh, input);
      if (found.isotropic_vertices > 0 || !found.has_known_curves ||
          found.not_proved != std::array<std::size_t, 2>{} || !components.not_proved[0].empty() ||
          !components.not_proved[1].empty())
        continue;
      ++compared;
      EXPECT_TRUE(found.adds_up[0] && found.adds_up[1]) << name_of(kind) << trial;
    }
}

/// The first Betti number of a link's vertices of positive sign, by the Euler characteristic.
int loops_of_rise(const SignedLink& link) {
  const auto rises = [&](int v) {
    return link.signs[static_cast<std::size_t>(v)] == Verdict::positive;
  };
  std::set<std::pair<int, int>> edges;
  int euler = static_cast<int>(std::count(link.signs.begin(), link.signs.end(), Verdict::positive));
  for (const auto& t : link.triangles) {
    euler += rises(t[0]) && rises(t[1]) && rises(t[2]);
    for (std::size_t i = 0; i < 3; ++i)
      if (const auto edge = std::minmax(t[i], t[(i + 1) % 3]);
          rises(edge.first) && rises(edge.second))
        edges.insert(edge);
  }
  euler -= static_cast<int>(edges.size());
  return static_cast<int>(parts_of_sign(link, Verdict::positive).size()) - euler;
}

// Alexander duality in the link, a disc being a sphere with what is outside of the mesh: a loop of
// the part with a larger mode separates components of the rest.
TEST(ModeHomology, LoopsInLinksSeparateTheRest) {
  Compared inside("links inside", 200), outside("links on the boundary", 200), loops("loops", 150);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    TetMesh mesh = cubes(3, seed % 2 == 0 ? Hole::none : Hole::middle);
    fill_with_normal_tensors(mesh, seed);
    for (const MeshCriticalPoint& point : mesh_critical_values(mesh, -1, 1).points) {
      if (point.effect.change == LocalChange::undecided) continue;
      const auto falls = parts_of_sign(point.link, Verdict::negative);
      const auto touches = parts_on_boundary(point.link, falls);
      const bool on_boundary = point.effect.on_boundary;
      const auto apart = std::count(touches.begin(), touches.end(), 0) + on_boundary;
      if (apart == 0) continue;  // a minimum inside: the whole link rises
      const int found = loops_of_rise(point.link);
      EXPECT_EQ(found, apart - 1);
      (on_boundary ? outside : inside).count();
      loops.count(found > 0);
    }
  }
}

using Tensor = SymmetricTensor<double>;

/// Where a set is not empty it has components.
/// @param largest  a mode that is reached
void expect_components_below(const ModeHomology& found, double largest, Compared& compared) {
  for (const BettiInterval& interval : found.betti[0]) {
    if (interval.high > largest || !interval.betti[0]) continue;
    EXPECT_GE(*interval.betti[0], 1) << interval.low << ' ' << interval.high;
    compared.count();
  }
}

bool is_proved(const PersistenceInput& input) {
  return std::all_of(input.trees.begin(), input.trees.end(), [](const MergeTree& tree) {
    return std::all_of(tree.merges.begin(), tree.merges.end(),
                       [](const ModeMerge& merge) { return merge.is_proved; });
  });
}

// A point of mode 1 or -1 that no degenerate curve goes through is an extremum of its own.
TEST(ModeHomology, CountsPointsOfModeOneThatAreOnNoCurve) {
  Compared compared("sets", 100), known("fields where all is proved", 20);
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    TetMesh mesh = cube_mesh(1);
    fill_with_normal_tensors(mesh, seed);
    if (seed % 2 == 0) {
      const auto& points = mesh.points;
      const auto& tet = mesh.tets[0];
      mesh = single_tet_mesh({points[as_size(tet[0])], points[as_size(tet[1])],
                              points[as_size(tet[2])], points[as_size(tet[3])]},
                             {mesh.tensors[0], mesh.tensors[1], mesh.tensors[2], mesh.tensors[3]});
    }
    const double x = random.integer(-3, 3), y = random.integer(-3, 3), z = random.integer(1, 3);
    const double sign = seed % 3 == 0 ? -1 : 1;
    mesh.tensors[seed % mesh.tensors.size()] =
        sign * Tensor{x * x, y * y, z * z, x * y, y * z, x * z};
    const PersistenceInput input = persistence_input(mesh);
    const ModeHomology found = mode_homology(mesh, input);
    if (sign > 0) expect_components_below(found, 1, compared);
    if (is_proved(input) && found.has_known_curves) {
      EXPECT_TRUE(found.adds_up[0] && found.adds_up[1]);
      known.count();
    }
    for (const PersistencePair& pair : mode_persistence(mesh, input).pairs) {
      if (pair.kind != PairKind::extended || !pair.is_certain) continue;
      EXPECT_EQ(sign > 0 ? pair.birth.high : -pair.death.low, 1);
    }
  }
}

// The middle of an edge has mode -1, and the mode is larger all around.
TEST(ModeHomology, DoesNotLoseAPointOfModeMinusOneInsideAnEdge) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  mesh.tets = {{0, 1, 2, 3}, {4, 1, 3, 2}};
  mesh.cell_ids = {0, 1};
  mesh.tensors = {Tensor{-2, -1, -1, 0, -2, 2}, Tensor{-4, 0, -4, -1, -3, 2},
                  Tensor{-3, -1, -1, 2, 1, 0}, Tensor{1, 2, 1, -1, -4, 4},
                  Tensor{-2, 3, -2, 0, -2, 2}};
  const PersistenceInput input = persistence_input(mesh);
  const ModeHomology found = mode_homology(mesh, input);
  for (const BettiInterval& interval : found.betti[1]) {
    EXPECT_GE(interval.betti[0].value_or(1), 1) << interval.low;
  }
  EXPECT_TRUE(!is_proved(input) || (found.adds_up[0] && found.adds_up[1]));
  for (const PersistencePair& pair : mode_persistence(mesh, input).pairs)
    EXPECT_TRUE(pair.kind != PairKind::extended || !pair.is_certain || pair.death.low <= -1);
}

// The opposite tensors have the opposite mode: superlevel and sublevel sets are exchanged.
TEST(ModeHomology, OfTheOppositeFieldIsTurnedAround) {
  Compared compared("pairs", 20);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const TetMesh mesh = strong_field(cube_mesh(2), seed), other = opposite(mesh);
    const ModeHomology found = mode_homology(mesh, persistence_input(mesh)),
                       turned = mode_homology(other, persistence_input(other));
    for (const int dimension : {1, 2}) {
      auto above = pairs_of(found, dimension, PairKind::superlevel),
           below = pairs_of(turned, dimension, PairKind::sublevel);
      ASSERT_EQ(above.size(), below.size());
      for (auto* list : {&above, &below})
        std::sort(list->begin(), list->end(), [](const SampledPair& a, const SampledPair& b) {
          return std::pair(a.birth, a.death) < std::pair(b.birth, b.death);
        });
      for (std::size_t i = 0; i < above.size(); ++i) {
        EXPECT_NEAR(above[i].birth, below[i].birth, 1e-7);
        EXPECT_NEAR(above[i].death, below[i].death, 1e-7);
        ++compared;
      }
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
