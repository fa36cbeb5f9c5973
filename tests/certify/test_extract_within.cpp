// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "certify_case.hpp"
#include "support/compared.hpp"
#include "tensortopo/certify/extract_within.hpp"

namespace tensortopo::test {
namespace {

class Within : public testing::TestWithParam<const char*> {};

// Where a curve turns sharply in a face a sample inside can lie too close to it for any reach to
// suffice; such a tetrahedron is named, and has to be rare.
TEST_P(Within, ReachesTheDistanceWithTheTopologyOfThePlainExtraction) {
  const auto mode = ModeValue::parse(GetParam());
  std::size_t crossed = 0, farther = 0;
  for (std::uint64_t seed = 20241301; seed < 20241305; ++seed) {
    SCOPED_TRACE(seed);
    TetMesh mesh = cube_mesh(1);
    fill_with_normal_tensors(mesh, seed);
    const auto plain = extract_mode_surface<double>(mesh, mode);
    ASSERT_GT(plain.surface.triangles.size(), 0u);
    for (const double distance : {0.1, 0.02}) {
      const auto within = extract_within(mesh, mode, distance);
      crossed += within.extraction.statistics.tets_crossed;
      farther += within.farther.size();
      if (within.farther.empty()) {
        EXPECT_LE(within.level.distance.bound, distance);
      }
      for (const auto t : within.level.distance.coarse)
        EXPECT_TRUE(within.level.distance.coarse_bound <= distance ||
                    std::count(within.farther.begin(), within.farther.end(), t) == 1);
      EXPECT_EQ(summary(within.extraction.surface), summary(plain.surface));
      EXPECT_EQ(flaws(within.extraction, mesh), "");
    }
  }
  std::cout << farther << " of " << crossed << " tetrahedra farther\n";
  EXPECT_LE(8 * farther, crossed);
}

INSTANTIATE_TEST_SUITE_P(Levels, Within, testing::Values("1/2", "-1/2", "1/10"));

// Denser samples do not help beside the singular line of a neutral surface: this ends all the same,
// and says where.
TEST(Within, GivesUpWhereMoreSamplesDoNotHelp) {
  Compared compared("triangles within the distance", 100);
  TetMesh mesh = cube_mesh(2);
  fill_with_smooth_tensors(mesh, 20241301, 4, 2);
  const double distance = 0.005;
  const auto within = extract_within(mesh, ModeValue::parse("0"), distance);
  for (std::size_t i = 0; i < within.extraction.surface.triangles.size(); ++i) {
    const auto t = within.extraction.surface.tet[i];
    const auto& coarse = within.level.distance.coarse;  // there it is proved otherwise
    if (std::binary_search(within.farther.begin(), within.farther.end(), t) ||
        std::binary_search(coarse.begin(), coarse.end(), t))
      continue;
    ++compared;
    for (const auto v : within.extraction.surface.triangles[i])
      EXPECT_LE(reach_length(within.level.distance.reach[static_cast<std::size_t>(v)]), distance);
  }
  EXPECT_LT(within.farther.size(), 5u);
}

// No distance is so small that this would not end, with a surface of a size that can be used.
TEST(Within, GivesUpWhereThereWouldBeTooManyTriangles) {
  Random random(20261122);
  const TetMesh mesh = reference_tet_mesh(random.tet_tensors());
  const auto plain = extract_mode_surface<double>(mesh, ModeValue::parse("1/10"));
  ASSERT_GT(plain.surface.triangles.size(), 0u);
  const auto within = extract_within(mesh, ModeValue::parse("1/10"), 1e-12);
  EXPECT_EQ(within.farther.size(), 1u);
  EXPECT_GT(within.extraction.surface.triangles.size(), 5000u);
  EXPECT_LT(within.extraction.surface.triangles.size(), 50000u);
  EXPECT_EQ(summary(within.extraction.surface), summary(plain.surface));
}

// Here all denser samples are thinned out again, so that there are never more triangles.
TEST(Within, GivesUpWhereSamplesDoNotMakeTriangles) {
  const auto diagonal = [](double x, double y, double z) {
    return SymmetricTensor<double>{x, y, z, 0, 0, 0};
  };
  const TetMesh mesh = reference_tet_mesh(
      {diagonal(2, -1, -1), diagonal(2, -1.1, -1), diagonal(2, -1, -1.2), diagonal(1, 0.5, -3)});
  const auto within = extract_within(mesh, ModeValue::parse("1/10"), 1e-12);
  EXPECT_EQ(within.farther.size(), 1u);
  EXPECT_LT(within.rounds, 12);
}

// A single extraction, as no samples are nearer than coordinates are rounded.
TEST(Within, GivesUpAtOnceBelowRounding) {
  Random random(20261129);
  const TetMesh mesh = reference_tet_mesh(random.tet_tensors());
  const auto within = extract_within(mesh, ModeValue::parse("1/10"), 1e-20);
  EXPECT_EQ(within.rounds, 1);
  EXPECT_EQ(within.farther.size(), 1u);
}

// Wherever sampling begins.
TEST(Within, ReachesTheDistanceFromCoarseSamplesAsWell) {
  Compared compared("surfaces", 4);
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const TetMesh mesh = reference_tet_mesh(Random(seed).tet_tensors());
    for (const double resolution : {1.0, 4.0}) {
      ExtractOptions options;
      options.sampling.resolution = resolution;
      const auto within = extract_within(mesh, ModeValue::parse("1/10"), 0.1, options);
      EXPECT_TRUE(within.farther.empty()) << seed << ' ' << resolution;
      compared.count(!within.extraction.surface.triangles.empty());
    }
  }
}

// Where what is asked for is too small for a proof by parts, a larger bound than that is proved,
// and not only the longest edge claimed.
TEST(Within, AskingForMoreDoesNotProveLess) {
  Compared compared("bounds in coarse tetrahedra", 3);
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    for (const char* mode : {"1/2", "4/5"}) {
      const TetMesh mesh = reference_tet_mesh(Random(seed).tet_tensors());
      const auto within = extract_within(mesh, ModeValue::parse(mode), 0.05);
      if (within.level.distance.coarse.empty()) continue;
      EXPECT_LT(within.level.distance.coarse_bound, 0.25) << seed << ' ' << mode;
      ++compared;
    }
}

// Only where it is needed.
TEST(Within, SamplesMoreDenselyOnlyWhereTheSurfaceIsFarFromTheLevel) {
  TetMesh mesh = cube_mesh(1);
  fill_with_normal_tensors(mesh, 20241302);
  const auto mode = ModeValue::parse("1/2");
  const auto within = extract_within(mesh, mode, 0.003);
  ASSERT_TRUE(within.farther.empty());
  ASSERT_GT(within.rounds, 2);
  ExtractOptions everywhere;
  everywhere.sampling.resolution *= std::exp2(within.rounds - 1);
  const auto dense = extract_mode_surface<double>(mesh, mode, everywhere);
  EXPECT_LT(within.extraction.surface.triangles.size(), dense.surface.triangles.size());
}

}  // namespace
}  // namespace tensortopo::test
