// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Fields with critical points whose links are not known: what is said all the same is right.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "sampled_persistence.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/persistence/mode_homology.hpp"
#include "tensortopo/persistence/mode_persistence.hpp"

namespace tensortopo::test {
namespace {

using Rows = std::vector<std::array<int, 6>>;  // xx, yy, zz, xy, yz, xz

TetMesh with_tensors(TetMesh mesh, const Rows& rows) {
  mesh.cell_ids.resize(mesh.tets.size());
  std::iota(mesh.cell_ids.begin(), mesh.cell_ids.end(), 0);
  for (const auto& r : rows) {
    SymmetricTensor<double> t;
    t.xx = r[0], t.yy = r[1], t.zz = r[2], t.xy = r[3], t.yz = r[4], t.xz = r[5];
    mesh.tensors.push_back(t);
  }
  return mesh;
}

TetMesh two_cubes(const Rows& rows) {
  TetMesh mesh;
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 2; ++y)
      for (int z = 0; z < 3; ++z)
        mesh.points.push_back(
            {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  // Three paths from corner to corner of each cube, each with two tetrahedra.
  for (const int z : {0, 1}) {
    const int from = z, to = z + 10, x = z + 6, y = z + 3, up = z + 1;
    mesh.tets.insert(mesh.tets.end(), {{from, x, x + 3, to},
                                       {from, x, to, x + 1},
                                       {from, y, to, x + 3},
                                       {from, y, y + 1, to},
                                       {from, up, x + 1, to},
                                       {from, up, to, y + 1}});
  }
  return with_tensors(mesh, rows);
}

/// Two tetrahedra that have one vertex in common.
TetMesh touching_tets(const Rows& rows) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  mesh.tets = {{0, 1, 2, 3}, {0, 4, 6, 5}};
  return with_tensors(mesh, rows);
}

// The component born at 0.376 meets an older one at 0.189 or above: through (0.625, 0.9167,
// 0.9583), where the mode is 0.5387.
TetMesh field_of_late_merge() {
  return two_cubes({{-2, 1, 1, 1, -1, 2},
                    {0, 1, 1, 0, -1, 1},
                    {-1, -2, -2, 1, 0, 1},
                    {1, -2, 1, 1, -2, 1},
                    {2, 0, -1, -1, -2, -1},
                    {0, -1, -1, -2, 2, -2},
                    {-2, -1, 0, 0, -2, 1},
                    {-2, -1, 0, 0, 1, -2},
                    {2, 2, 0, -2, 2, 0},
                    {-2, 0, -2, 2, 1, -1},
                    {1, 1, -1, -2, 1, 2},
                    {-2, -2, 1, 1, 0, 2}});
}
// The one born at -0.515 as the mode rises meets an older one below 0.065.
TetMesh field_of_late_merge_below() {
  return two_cubes({{0, 1, 0, 1, 0, -1},
                    {0, 0, 1, -1, -1, 1},
                    {1, 0, 1, 1, 1, 1},
                    {0, 1, -1, 0, 1, 1},
                    {1, 0, -1, -1, 1, 0},
                    {1, -1, -1, -1, 0, -1},
                    {-1, -1, 1, 0, 1, -1},
                    {0, -1, 0, -1, 1, -1},
                    {-1, 0, 0, 0, 1, 1},
                    {-1, 1, -1, -1, -1, 0},
                    {-1, 1, 0, 1, 1, 0},
                    {-1, 1, -1, 1, -1, 1}});
}
// {mode <= m} has one component for m from -0.489 to 0.325 and two from there to 0.916.
TetMesh field_of_two_fans() {
  return touching_tets({{-1, -2, -1, 1, 2, -1},
                        {2, 1, 0, 2, 2, 2},
                        {2, -1, -1, -1, 0, -2},
                        {-2, -1, 1, 1, -2, -1},
                        {1, 2, -1, -2, 1, 2},
                        {-1, -2, 1, 1, -1, 0},
                        {1, 2, 1, -2, -1, 1}});
}

TEST(OpenPoints, MakePairsUncertainThatTheyMayEnd) {
  const TetMesh above = field_of_late_merge(), below = field_of_late_merge_below();
  Compared compared("pairs that would be wrong", 2);
  for (const PersistencePair& pair : mode_persistence(above, persistence_input(above)).pairs) {
    if (pair.kind != PairKind::superlevel || std::abs(pair.birth.middle() - 0.376135) > 1e-3)
      continue;
    EXPECT_TRUE(!pair.is_certain || pair.death.high > 0.18);
    ++compared;
  }
  for (const PersistencePair& pair : mode_persistence(below, persistence_input(below)).pairs) {
    if (pair.kind != PairKind::sublevel || std::abs(pair.birth.middle() + 0.5146) > 1e-3) continue;
    EXPECT_TRUE(!pair.is_certain || pair.death.low < 0.07);
    ++compared;
  }
}

std::optional<long> components_at(const TetMesh& mesh, PairKind kind, double mode) {
  const ModeHomology found = mode_homology(mesh, persistence_input(mesh));
  for (const BettiInterval& interval : found.betti[kind == PairKind::superlevel ? 0 : 1])
    if (interval.low < mode && mode < interval.high) return interval.betti[0];
  return std::nullopt;
}

TEST(OpenPoints, LeaveOpenHowManyComponentsThereAre) {
  for (const double mode : {-0.4, 0.0, 0.2})
    EXPECT_EQ(components_at(field_of_two_fans(), PairKind::sublevel, mode).value_or(1), 1) << mode;
  for (const double mode : {0.4, 0.6, 0.9})
    EXPECT_EQ(components_at(field_of_two_fans(), PairKind::sublevel, mode).value_or(2), 2) << mode;
  EXPECT_EQ(components_at(field_of_two_fans(), PairKind::sublevel, 0.97).value_or(1), 1);
  for (const double mode : {0.1, 0.3, 0.4})
    EXPECT_EQ(components_at(field_of_late_merge_below(), PairKind::sublevel, mode).value_or(1), 1)
        << mode;
}

/// The certain pairs of a kind, in signed Lode angles turned so that they fall.
std::vector<SampledPair> certain_pairs(const ModePersistence& found, PairKind kind) {
  const double sign = kind == PairKind::sublevel ? -1 : 1;
  std::vector<SampledPair> pairs;
  for (const PersistencePair& pair : found.pairs)
    if (pair.kind == kind && pair.is_certain && !pair.is_tie)
      pairs.push_back({sign * signed_lode_angle(pair.birth.middle()),
                       sign * signed_lode_angle(pair.death.middle())});
  return pairs;
}

/// The certain pairs are among those of a sampled field, within its error.
void compare_with_samples(const TetMesh& mesh, const ModePersistence& found, int trial,
                          Compared& compared) {
  const SampledPersistence sampled = sampled_persistence(mesh, 4);
  const double error = sampled.error;
  for (const PairKind kind : {PairKind::superlevel, PairKind::sublevel}) {
    const auto certain = certain_pairs(found, kind);
    const auto& all = kind == PairKind::superlevel ? sampled.superlevel : sampled.sublevel;
    for (double a = -0.5; a < 0.53; a += 0.02)
      for (double b = -0.52; b < a; b += 0.02) {
        const int rank = rank_between(certain, a + error, b - error);
        EXPECT_GE(rank_between(all, a, b), rank) << "trial " << trial << ", " << a << ' ' << b;
        compared.count(rank > 0);
      }
  }
}

// Small integers around a neutral tensor: many points are in special position, few places are near
// an isotropic tensor, and sampling shows about where components meet.
TEST(OpenPoints, CertainPairsAreThoseOfSampledFields) {
  Compared compared("ranks that are not zero", 300), open("fields with open points", 3);
  Random random(20261128);
  for (int trial = 0; trial < trials(60, 20); ++trial) {
    TetMesh mesh = trial % 4 == 3 ? field_of_two_fans() : field_of_late_merge();
    for (auto& t : mesh.tensors) {
      t = SymmetricTensor<double>{3, 0, -3, 0, 0, 0};
      for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *x += random.integer(-1, 1);
    }
    const ModePersistence found = mode_persistence(mesh, persistence_input(mesh));
    open.count(!found.not_proved[0].empty() || !found.not_proved[1].empty());
    compare_with_samples(mesh, found, trial, compared);
  }
}

// As real fields are: a plane of symmetry but for rounding, so that degenerate curves of mode 1
// cross edges at less than doubles show.
TEST(OpenPoints, OnPlanesOfSymmetryAreDecided) {
  Compared compared("ranks that are not zero", 60), decided("points next to a curve", 30),
      added("fields without an open point", 5);
  Random random(20261129);
  for (int trial = 0; trial < trials(60, 20); ++trial) {
    TetMesh mesh = field_of_late_merge();
    for (std::size_t v = 0; v < mesh.tensors.size(); ++v) {
      SymmetricTensor<double>& t = mesh.tensors[v];
      t = {3, -1.5, -1.5, 0, 0, 0};
      for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *x += 2 * random.uniform() - 1;
      if (mesh.points[v].z == 1) t.yz *= 1e-13, t.xz *= 1e-13;
    }
    const PersistenceInput input = persistence_input(mesh);
    for (const MeshCriticalPoint& point : input.values.points) {
      EXPECT_NE(point.effect.change, LocalChange::undecided) << "trial " << trial;
      decided.count(point.gap_high < 1e-20);
    }
    const ModePersistence found = mode_persistence(mesh, input);
    compare_with_samples(mesh, found, trial, compared);
    if (!found.not_proved[0].empty() || !found.not_proved[1].empty()) continue;
    // Births and deaths of all dimensions, at these points as well, make up the mesh's homology.
    const ModeHomology homology = mode_homology(mesh, input);
    EXPECT_TRUE(homology.adds_up[0] && homology.adds_up[1]) << "trial " << trial;
    ++added;
  }
}

}  // namespace
}  // namespace tensortopo::test
