// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "embedding/field_surface.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo::test {
namespace {

struct Level {
  const char* text;
  embedding::Mode mode;
};

constexpr Level kLevels[] = {{"0", {0, 1}},
                             {"1/2", {1, 2}},
                             {"-9/10", {-9, 10}},
                             {"99/100", {99, 100}},
                             {"-999/1000", {-999, 1000}}};

struct Count {
  std::size_t triangles = 0, vertices = 0, reported = 0;
};

/// What is not reported is embedded, faces larger modes, and lies on the level.
void expect_embedded(const TetMesh& mesh, const Level& level, Count& count) {
  const auto result =
      extract_mode_surface<double>(mesh, ModeValue::parse(level.text));
  const auto surface = embedding::surface_of(result.surface);
  const auto field = embedding::field_of(mesh);
  const auto is_reported = [&](std::int32_t tet) {
    return std::find(result.not_embedded.begin(), result.not_embedded.end(), tet) !=
           result.not_embedded.end();
  };
  for (const auto& pair : embedding::intersections(surface).pairs)
    EXPECT_TRUE(is_reported(surface.tet[pair.first]) && is_reported(surface.tet[pair.second]))
        << level.text << ": triangles " << pair.first << " and " << pair.second;
  const auto against = embedding::against_gradient(surface, field);
  for (const auto t : against.at_centroid)
    EXPECT_TRUE(is_reported(surface.tet[t])) << level.text << ": triangle " << t;
  const auto off = embedding::residuals(surface, field, level.mode);
  EXPECT_EQ(off.off.size(), 0u) << level.text << ": largest residual " << off.largest;
  count.triangles += against.compared;
  count.vertices += off.compared;
  count.reported += result.not_embedded.size();
}

TEST(RandomTetrahedra, HaveEmbeddedSurfaces) {
  Count count;
  constexpr int kTets = 20;
  Random random(20261123);
  for (int trial = 0; trial < kTets; ++trial) {
    const auto mesh = reference_tet_mesh(random.tet_tensors());
    SCOPED_TRACE("tetrahedron " + std::to_string(trial));
    for (const auto& level : kLevels) expect_embedded(mesh, level, count);
  }
  EXPECT_GT(count.triangles, 1000u);
  EXPECT_GT(count.vertices, 1000u);
  EXPECT_LE(count.reported, 2u);
}

TEST(RandomMeshes, HaveEmbeddedSurfaces) {
  Count count;
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    TetMesh mesh = cube_mesh(2);
    if (seed % 2 == 0)
      fill_with_normal_tensors(mesh, seed);
    else
      fill_with_smooth_tensors(mesh, seed);
    SCOPED_TRACE("mesh " + std::to_string(seed));
    for (const auto& level : kLevels) expect_embedded(mesh, level, count);
  }
  EXPECT_GT(count.triangles, 1000u);
  EXPECT_LE(count.reported, 2u);
}

}  // namespace
}  // namespace tensortopo::test
