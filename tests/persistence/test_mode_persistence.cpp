// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sampled_persistence.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/persistence/mode_persistence.hpp"

namespace tensortopo::test {
namespace {

/// The pairs of one kind and the extended one, in signed Lode angles, turned so that they fall.
std::vector<SampledPair> pairs_of(const ModePersistence& found, PairKind kind) {
  std::vector<SampledPair> pairs;
  const double sign = kind == PairKind::sublevel ? -1 : 1;
  for (const PersistencePair& p : found.pairs) {
    const double birth = signed_lode_angle(p.birth.middle());
    const double death = signed_lode_angle(p.death.middle());
    if (p.kind == kind) pairs.push_back({sign * birth, sign * death});
    if (p.kind == PairKind::extended)
      pairs.push_back(sign > 0 ? SampledPair{birth, death} : SampledPair{-death, -birth});
  }
  return pairs;
}

TetMesh noisy_cube(int n, std::uint64_t seed) {
  TetMesh mesh = cube_mesh(n);
  fill_with_normal_tensors(mesh, seed);
  return mesh;
}

/// The same around a neutral tensor, so that the deviator is small nowhere.
TetMesh strong_cube(int n, std::uint64_t seed) {
  TetMesh mesh = noisy_cube(n, seed);
  for (auto& tensor : mesh.tensors)
    tensor = 0.7 * tensor + SymmetricTensor<double>{2.5, 0, -2.5, 0, 0, 0};
  return mesh;
}

// Diagrams of functions that differ by e at most are interleaved: each rank is between the other's
// with arguments moved by e.
void expect_interleaved(const std::vector<SampledPair>& exact,
                        const std::vector<SampledPair>& sampled, double error, Compared& compared,
                        Compared& more) {
  for (double a = -0.5; a < 0.53; a += 0.02)
    for (double b = -0.52; b < a; b += 0.02) {
      const int rank = rank_between(sampled, a, b);
      EXPECT_GE(rank, rank_between(exact, a + error, b - error)) << a << ' ' << b;
      if (a - error > b + error) {
        EXPECT_LE(rank, rank_between(exact, a - error, b + error)) << a << ' ' << b;
      }
      compared.count(rank > 0);
      more.count(rank > 1);
    }
}

TEST(ModePersistence, AgreesWithBruteForceWithinItsError) {
  Compared compared("ranks that are not zero", 5000), more("ranks above one", 500);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TetMesh mesh = strong_cube(2, seed);
    const ModePersistence found = mode_persistence(mesh, persistence_input(mesh));
    EXPECT_TRUE(found.not_proved[0].empty() && found.not_proved[1].empty()) << seed;
    const SampledPersistence sampled = sampled_persistence(mesh, 4);
    EXPECT_LT(sampled.error, 0.05);
    expect_interleaved(pairs_of(found, PairKind::superlevel), sampled.superlevel, sampled.error,
                       compared, more);
    expect_interleaved(pairs_of(found, PairKind::sublevel), sampled.sublevel, sampled.error,
                       compared, more);
  }
}

// Independent tensors at all vertices: nothing is left open, and nothing is a tie.
TEST(ModePersistence, IsProvedOnNoise) {
  Compared pairs("pairs", 100);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const TetMesh mesh = noisy_cube(1, seed);
    const ModePersistence found = mode_persistence(mesh, persistence_input(mesh));
    EXPECT_TRUE(found.not_proved[0].empty() && found.not_proved[1].empty()) << seed;
    int whole = 0;
    for (const PersistencePair& pair : found.pairs) {
      EXPECT_TRUE(pair.is_certain) << seed;
      EXPECT_TRUE(pair.has_death) << seed << " " << name_of(pair.kind) << pair.birth.low << " "
                                  << pair.birth.high << " curve " << pair.curve.has_value();
      EXPECT_FALSE(pair.is_tie) << seed;
      EXPECT_LT(pair.birth.high - pair.birth.low, 1e-9);
      EXPECT_LT(pair.death.high - pair.death.low, 1e-9);
      EXPECT_GT(survived_noise(pair), 0);
      whole += pair.kind == PairKind::extended;
      ++pairs;
    }
    EXPECT_EQ(whole, 1) << seed;
  }
}

// The opposite tensors have the opposite mode.
TEST(ModePersistence, OfTheOppositeFieldIsTurnedAround) {
  Compared compared("pairs", 30);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const TetMesh mesh = strong_cube(2, seed), other = opposite(mesh);
    const auto pairs = mode_persistence(mesh, persistence_input(mesh)).pairs,
               turned = mode_persistence(other, persistence_input(other)).pairs;
    const auto values = [](const std::vector<PersistencePair>& of, PairKind kind, double sign) {
      std::vector<std::array<double, 2>> found;
      for (const PersistencePair& pair : of)
        if (pair.kind == kind)
          found.push_back({sign * pair.birth.middle(), sign * pair.death.middle()});
      std::sort(found.begin(), found.end());
      return found;
    };
    const auto above = values(pairs, PairKind::superlevel, 1),
               below = values(turned, PairKind::sublevel, -1);
    ASSERT_EQ(above.size(), below.size());
    for (std::size_t i = 0; i < above.size(); ++i) {
      EXPECT_NEAR(above[i][0], below[i][0], 1e-9);
      EXPECT_NEAR(above[i][1], below[i][1], 1e-9);
      ++compared;
    }
  }
}

// Also where differences of components overflow, or 1 over a component does.
TEST(ModePersistence, IsTheSameInAnyUnits) {
  Compared compared("pairs", 100);
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    TetMesh mesh = noisy_cube(2, seed);
    for (auto& tensor : mesh.tensors) {  // digits that remain in the smallest doubles
      for (double* x : {&tensor.xx, &tensor.yy, &tensor.zz, &tensor.xy, &tensor.yz, &tensor.xz})
        *x = std::ldexp(std::round(std::ldexp(*x, 16)), -16);
    }
    const ModePersistence expected = mode_persistence(mesh, persistence_input(mesh));
    for (const int exponent : {-1050, -500, 500, 1021}) {
      TetMesh scaled = mesh;
      for (auto& tensor : scaled.tensors)
        tensor =
            std::ldexp(1.0, exponent / 2) * (std::ldexp(1.0, exponent - exponent / 2) * tensor);
      const ModePersistence found = mode_persistence(scaled, persistence_input(scaled));
      EXPECT_EQ(found.not_proved, expected.not_proved) << seed << ' ' << exponent;
      EXPECT_EQ(found.unresolved_curve_cells, expected.unresolved_curve_cells)
          << seed << ' ' << exponent;
      ASSERT_EQ(found.pairs.size(), expected.pairs.size()) << seed << ' ' << exponent;
      for (std::size_t i = 0; i < found.pairs.size(); ++i) {
        EXPECT_EQ(found.pairs[i].birth.low, expected.pairs[i].birth.low);
        EXPECT_EQ(found.pairs[i].death.high, expected.pairs[i].death.high);
        EXPECT_EQ(found.pairs[i].birth_point, expected.pairs[i].birth_point);
        EXPECT_EQ(found.pairs[i].is_certain, expected.pairs[i].is_certain);
        ++compared;
      }
    }
  }
}

// A field that is the same on both sides of a centre: of two equal maxima that meet, either may
// count as the older one.
TEST(ModePersistence, SymmetricFieldsHaveTies) {
  Compared ties("ties", 3);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    TetMesh mesh = strong_cube(2, seed);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      for (std::size_t w = v + 1; w < mesh.points.size(); ++w)
        if (mesh.points[v] + mesh.points[w] == Vector3<double>{2, 2, 2})
          mesh.tensors[w] = mesh.tensors[v];
    for (const PersistencePair& pair : mode_persistence(mesh, persistence_input(mesh)).pairs)
      ties.count(pair.is_tie);
  }
}

TEST(ModePersistence, NoiseThatIsSurvived) {
  PersistencePair pair;
  pair.birth = {1, 1};
  pair.death = {-1, -1};
  EXPECT_NEAR(survived_noise(pair), 0.5, 1e-12);  // sin(60 degrees / 2)
  pair.death = {0, 0};
  EXPECT_NEAR(angle_persistence(pair), std::numbers::pi / 6, 1e-12);
  pair.death = {-0.5, 0.5};  // what is certain
  EXPECT_NEAR(angle_persistence(pair), std::asin(1) / 3 - std::asin(0.5) / 3, 1e-12);
}

}  // namespace
}  // namespace tensortopo::test
