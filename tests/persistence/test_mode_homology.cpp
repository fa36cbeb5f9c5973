// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "sampled_homology.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
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
      pairs.push_back({sign * angle(p.birth.middle()),
                       p.is_lasting ? -2 : sign * angle(p.death.middle())});
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
      EXPECT_TRUE(interval.is_certain[k]);
      EXPECT_EQ(interval.betti[k], rank_between(sampled.pairs[k], middle + e, middle - e))
          << k << " at " << middle;
      comparison.betti[k] += interval.betti[k] > 0;
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

TEST(ModeHomology, Explore) {
  for (int n = 1; n <= 4; ++n) {
    Comparison c;
    std::size_t pairs=0, loops=0, points = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const TetMesh mesh = strong_field(n < 3 ? cube_mesh(n) : cubes(3, n == 3 ? Hole::column : Hole::middle), seed);
      const auto found = mode_homology(mesh, persistence_input(mesh));
      EXPECT_TRUE(found.adds_up[0] && found.adds_up[1]);
      for (const auto& p : found.pairs) pairs += p.dimension == 1;
      for (const auto& l : found.loops) loops += l.count * l.is_birth;
      points += found.not_proved[0];
      for (auto kind : {PairKind::superlevel, PairKind::sublevel})
        compare(mesh, found, n == 1 ? 4 : n < 3 ? 3 : 2, kind, c);
    }
    printf("n %d: betti %zu %zu %zu ranks %zu %zu all loops %zu pairs %zu of %zu loops; notproved %zu\n", n, c.betti[0], c.betti[1], c.betti[2], c.ranks[1], c.ranks[2], c.all_loops, pairs, loops, points);
  }
}

}  // namespace
}  // namespace tensortopo::test
