// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What is computed of several simplices at once is, bit for bit, what is computed of each.
#include "extract/level/simd/lane_kernels.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <iostream>
#include <limits>

#include "extract/cases/extract_case.hpp"
#include "extract/level/proofs/direction_search.hpp"
#include "extract/topology/boundary/arc_samples.hpp"
#include "extract/topology/boundary/edge_crossings.hpp"
#include "extract/topology/boundary/graph_arcs.hpp"
#include "support/compared.hpp"

namespace tensortopo::test {
namespace {

template <std::size_t Count>
using Simplex = std::array<Deviator<double>, Count>;

Deviator<double> to_size(const Deviator<double>& t) {
  const double norm = std::sqrt(norm_form(t));
  return norm > 0 ? std::ldexp(1.0, -std::ilogb(norm / 1.74)) * t : t;
}

Deviator<double> integers(Random& random) {
  const auto entry = [&] { return static_cast<double>(random.integer(-2, 2)); };
  return {entry(), entry(), entry(), entry(), entry()};
}

/// Tensors side by side as in a smooth field, or special ones: small integers, with ties, equal
/// vertices, low rank and zeros; next to a zero; of any size; not a number.
template <std::size_t Count>
Simplex<Count> random_simplex(Random& random, int kind) {
  Simplex<Count> result;
  const auto normal = [&] { return deviator(random.tensor()); };
  const auto centre = normal();
  const double spread = std::ldexp(1.0, -random.integer(0, 8));
  for (auto& t : result) {
    t = kind % 4 == 0 ? integers(random) : to_size(centre + spread * normal());
    if (kind % 16 == 1) t = std::ldexp(1.0, -random.integer(0, 300)) * t;
    if (kind % 16 == 2) t.yz = t.xz = 0;
  }
  if (kind % 64 == 3) result[0].xy = std::numeric_limits<double>::quiet_NaN();
  if (kind % 64 == 7) result[1] = 1e150 * result[1];
  return result;
}

template <class Numbers>
bool same_bits(const Numbers& a, const Numbers& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  return true;
}

template <std::size_t Vertices>
void expect_proofs_of_one(std::uint64_t seed, int count) {
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int monotone = 0, other = 0;
  for (int trial = 0; trial < count; ++trial) {
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const auto level = make_level<double>(mode);
    std::vector<Simplex<Vertices>> simplices(static_cast<std::size_t>(random.integer(1, 9)));
    for (auto& s : simplices)  // most of them crossed by the level
      do s = random_simplex<Vertices>(random, random.integer(0, 1000));
      while (!is_crossed(s, level.mu) && random.uniform() < 0.9);
    std::vector<SimplexProof<double, Vertices>> proofs(simplices.size());
    prove_simplices<Vertices>(simplices, level, proofs);
    for (std::size_t i = 0; i < simplices.size(); ++i) {
      const auto expected = prove_simplex(simplices[i], level);
      ASSERT_EQ(proofs[i].kind, expected.kind) << "trial " << trial << ", simplex " << i;
      ASSERT_EQ(proofs[i].inconclusive, expected.inconclusive) << "trial " << trial;
      ASSERT_TRUE(same_bits(proofs[i].direction, expected.direction))
          << "trial " << trial << ", simplex " << i << " of " << simplices.size();
      ++(expected.kind == SimplexProof<double, Vertices>::Kind::monotone ? monotone : other);
    }
  }
  std::cout << Vertices << " vertices: " << monotone << " monotone, " << other << " not\n";
  EXPECT_GT(monotone, count / 2);
  EXPECT_GT(other, count / 2);
}

TEST(LaneKernels, ProveTrianglesAsOneByOne) { expect_proofs_of_one<3>(20240411, trials(1500)); }
TEST(LaneKernels, ProveTetrahedraAsOneByOne) { expect_proofs_of_one<4>(20240412, trials(1500)); }

/// What `DirectionSearch::run` finds without lanes, step by step.
template <std::size_t Vertices>
std::array<double, Vertices> found_by_definition(DirectionSearch<Vertices> search, int steps) {
  constexpr std::size_t count = DirectionSearch<Vertices>::count;
  for (int step = 0;; ++step) {
    std::array<double, count> growth;
    for (std::size_t k = 0; k < count; ++k) {
      growth[k] = search.d[0] * search.unit[0][k];
      for (std::size_t i = 1; i < Vertices; ++i) growth[k] += search.d[i] * search.unit[i][k];
    }
    std::size_t least = 0, most = count;
    for (std::size_t k = 0; k < count; ++k) {
      if (growth[k] < growth[least]) least = k;
      if (search.weight[k] > 0 && (most == count || growth[k] > growth[most])) most = k;
    }
    double square = 0, gap = 0, largest = 0;
    std::array<double, Vertices> way;
    for (std::size_t i = 0; i < Vertices; ++i) {
      square += search.d[i] * search.d[i];
      way[i] = search.unit[i][least] - search.unit[i][most];
      gap += way[i] * way[i];
      largest = std::max(largest, std::abs(search.d[i]));
    }
    if (growth[least] > search.enough) {
      for (auto& x : search.d) x /= largest;
      return search.d;
    }
    if (!(square > search.nothing * search.nothing) || step == steps || !(gap > 0)) return {};
    const double shift = std::min(search.weight[most], (growth[most] - growth[least]) / gap);
    search.weight[least] += shift;
    search.weight[most] -= shift;
    for (std::size_t i = 0; i < Vertices; ++i) search.d[i] += shift * way[i];
  }
}

/// Unit directions: random ones, with ties, around one of them or everywhere.
template <std::size_t Vertices>
DirectionSearch<Vertices> random_search(Random& random) {
  DirectionSearch<Vertices> search;
  const bool is_coarse = random.uniform() < 0.3;
  const double spread = std::ldexp(1.0, random.integer(-3, 2));
  for (std::size_t k = 0; k < search.count; ++k) {
    std::array<double, Vertices> x;
    double square = 0;
    for (std::size_t i = 0; i < Vertices; ++i) {
      x[i] = is_coarse ? random.integer(-1, 1) + (i == 0 ? 0.5 : 0)
                       : (i == 0 ? 1 : 0) + spread * (random.uniform() - 0.5);
      square += x[i] * x[i];
    }
    for (std::size_t i = 0; i < Vertices; ++i) search.unit[i][k] = x[i] / std::sqrt(square);
    search.weight[k] = 1.0 / search.count;
  }
  for (std::size_t i = 0; i < Vertices; ++i) {
    for (const double x : search.unit[i]) search.d[i] += x;
    search.d[i] /= search.count;
  }
  return search;
}

template <std::size_t Vertices>
void expect_direction_by_definition(std::uint64_t seed, int count) {
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  const auto at_least = static_cast<std::size_t>(count / 8);
  Compared found("found", at_least), none("without a direction", at_least);
  for (int trial = 0; trial < count; ++trial) {
    const auto search = random_search<Vertices>(random);
    const int steps = random.integer(0, kLongSearch);
    auto by_run = search;
    const auto direction = by_run.run(0, steps);
    ASSERT_TRUE(same_bits(direction, found_by_definition(search, steps))) << "trial " << trial;
    ++(direction == std::array<double, Vertices>{} ? none : found);
  }
}

TEST(LaneKernels, SearchForDirectionsAsByDefinition) {
  expect_direction_by_definition<3>(20240418, trials(4000));
  expect_direction_by_definition<4>(20240419, trials(4000));
}

template <std::size_t Vertices>
void expect_emptiness_of_one(std::uint64_t seed, int count) {
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  Compared empty("empty", static_cast<std::size_t>(count)),
      other("not proved empty", static_cast<std::size_t>(count / 2));
  for (int trial = 0; trial < count; ++trial) {
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const auto level = make_level<double>(mode);
    std::vector<Simplex<Vertices>> simplices(static_cast<std::size_t>(random.integer(1, 9)));
    for (auto& s : simplices) s = random_simplex<Vertices>(random, random.integer(0, 1000));
    std::vector<char> proved(simplices.size(), 2);
    prove_empty<Vertices>(simplices, level, proved);
    for (std::size_t i = 0; i < simplices.size(); ++i) {
      const bool expected = is_proved_empty(simplices[i], level);
      ASSERT_EQ(proved[i] != 0, expected) << "trial " << trial << ", simplex " << i;
      ++(expected ? empty : other);
    }
  }
}

TEST(LaneKernels, ProveEmptinessAsOneByOne) {
  expect_emptiness_of_one<2>(20240415, trials(1500));
  expect_emptiness_of_one<3>(20240416, trials(1500));
  expect_emptiness_of_one<4>(20240417, trials(1500));
}

// A crossing is that of `edge_crossings`; most edges have one that is found so.
TEST(LaneKernels, CrossEdgesAsOneByOne) {
  if (!has_lanes()) GTEST_SKIP() << "no AVX2";
  const std::uint64_t seed = 20240413;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  std::size_t found = 0, left = 0;
  for (int trial = 0; trial < trials(3000); ++trial) {
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const auto level = make_level<double>(mode);
    std::vector<Simplex<2>> edges;
    std::vector<char> rising;
    const auto wanted = static_cast<std::size_t>(random.integer(1, 9));
    while (edges.size() < wanted) {
      const auto ends = random_simplex<2>(random, random.integer(0, 1000));
      const auto first = side_of_level(ends[0], level), second = side_of_level(ends[1], level);
      if (first == second || first == Verdict::unknown || second == Verdict::unknown) continue;
      edges.push_back(ends);
      rising.push_back(second == Verdict::positive);
    }
    std::vector<double> weights(edges.size(), -2);
    single_crossings(edges, rising, level, weights);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (weights[i] == -1) {
        ++left;
        continue;
      }
      ++found;
      // The bits of the field are not asked for where double decides.
      const SymmetricTensor<double> none{};
      LevelSimplex<double, 2> edge;
      edge.tensors = edges[i];
      edge.above = {rising[i] == 0, rising[i] != 0};
      edge.exact = {&none, &none};
      const auto expected = edge_crossings(edge, level);
      ASSERT_TRUE(expected) << "trial " << trial;
      ASSERT_EQ(expected->size(), 1u) << "trial " << trial;
      ASSERT_EQ((*expected)[0].rising, rising[i] != 0);
      ASSERT_TRUE(same_bits(std::array{weights[i]}, std::array{(*expected)[0].weight}))
          << "trial " << trial << ": " << exact_text(weights[i]) << " instead of "
          << exact_text((*expected)[0].weight);
    }
  }
  std::cout << found << " crossings found, " << left << " edges left\n";
  EXPECT_GT(found, left / 2);
}

// An arc called straight gets no sample; most that get none are called so.
TEST(LaneKernels, SampleArcsAsOneByOne) {
  const std::uint64_t seed = 20240911;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  const Sampling sampling;
  const SampleTurns turns(sampling);
  std::size_t straight_ones = 0, bent = 0, left = 0;
  for (int trial = 0; trial < trials(3000); ++trial) {
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const auto level = make_level<double>(mode);
    std::vector<FaceArc<double>> arcs;
    std::vector<GraphArc> graph_arcs;
    const auto wanted = static_cast<std::size_t>(random.integer(1, 9));
    for (int attempt = 0; attempt < 100 && arcs.size() < wanted; ++attempt) {
      const SymmetricTensor<double> none{};  // not asked for where double decides
      LevelSimplex<double, 3> face{};
      face.tensors = random_simplex<3>(random, 16 * random.integer(1, 60) + 5);
      face.exact = {&none, &none, &none};
      bool is_sure = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto side = side_of_level(face.tensors[i], level);
        is_sure = is_sure && side != Verdict::unknown;
        face.above[i] = side == Verdict::positive;
      }
      const auto proof = prove_simplex(face.tensors, level);
      if (!is_sure || proof.kind != SimplexProof<double, 3>::Kind::monotone) continue;
      std::array<std::vector<EdgeCrossing<double>>, 3> crossings;
      std::size_t count = 0;
      for (std::size_t e = 0; e < 3; ++e) {
        const std::size_t a = e < 2 ? 0 : 1, b = e == 0 ? 1 : 2;
        const LevelSimplex<double, 2> edge{{face.tensors[a], face.tensors[b]},
                                           {face.above[a], face.above[b]},
                                           {&none, &none},
                                           {0, 0}};
        const auto found = edge_crossings(edge, level);
        if (!found || found->size() > 1) count = 9;
        if (found) crossings[e] = *found, count += found->size();
      }
      std::vector<FaceArc<double>> found;
      if (count != 2 || !arcs_of_graph<double>(face, {crossings[0], crossings[1], crossings[2]},
                                               level, found, &proof))
        continue;
      const auto& piece = found[0].pieces[0];
      graph_arcs.push_back({face.tensors, piece.direction, piece.begin, piece.end});
      arcs.push_back(std::move(found[0]));
    }
    std::vector<char> straight(arcs.size(), 2);
    straight_arcs(graph_arcs, level, {turns.medium, turns.tensor}, straight);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      sample_arc(arcs[i], graph_arcs[i].tensors, level, turns);
      const bool has_none = arcs[i].samples.empty();
      if (straight[i] != 0) {
        ASSERT_TRUE(has_none) << "trial " << trial << ", arc " << i;
        ++straight_ones;
      } else {
        ++(has_none ? left : bent);
      }
    }
  }
  std::cout << straight_ones << " straight arcs, " << bent << " bent, " << left << " left\n";
  if (!has_lanes()) return;
  EXPECT_GT(straight_ones, 20 * left);
  EXPECT_GT(bent, 0u);
}

}  // namespace
}  // namespace tensortopo::test
