// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <cstring>
#include <iostream>

#include "extract/cases/extract_case.hpp"
#include "extract/cases/fine_mesh.hpp"
#include "extract/cases/laws.hpp"

namespace tensortopo::test {
namespace {

class RandomMeshes : public testing::TestWithParam<const char*> {};

TEST_P(RandomMeshes, OfIndependentTensorsGiveFlawlessSurfaces) {
  expect_flawless_surfaces(GetParam(), trials(3), 2, false, 20240801);
}

TEST_P(RandomMeshes, OfSmoothFieldsGiveFlawlessSurfaces) {
  expect_flawless_surfaces(GetParam(), trials(2), 3, true, 20240802);
}

// The whole surface, not tetrahedron by tetrahedron: on the same field, subdivided.
TEST_P(RandomMeshes, OfSmoothFieldsHaveTheTopologyThatFineMarchingTetrahedraSee) {
  const std::string mode = GetParam();
  const std::uint64_t seed = 20240803;
  SCOPED_TRACE("mode " + mode + ", " + announce(seed));
  int decided = 0;
  const int count = trials(4, 2);
  for (int trial = 0; trial < count; ++trial) {
    TetMesh mesh = cube_mesh(3);
    fill_with_smooth_tensors(mesh, seed + static_cast<std::uint64_t>(trial));
    const auto coarse = fine_components(mesh, 3, mode, 16),
               fine = fine_components(mesh, 3, mode, 24);
    const Extraction extraction = extract(mesh, mode);
    if (coarse != fine) continue;
    ++decided;
    EXPECT_EQ(summary(extraction.surface).components, fine) << "trial " << trial;
  }
  std::cout << "decided " << decided << " of " << count << '\n';
  EXPECT_GE(2 * decided, count);
}

INSTANTIATE_TEST_SUITE_P(Levels, RandomMeshes, testing::ValuesIn(kLevels));

TEST(RandomMeshesNextToModeZero, GiveFlawlessSurfaces) {
  for (const char* mode : {"1/1000", "-1/1000"}) {
    expect_flawless_surfaces(mode, trials(2), 2, false, 20240804);
    expect_flawless_surfaces(mode, trials(2), 3, true, 20240804);
  }
}

TEST(Extraction, OfSeveralModesGivesTheSurfacesOfEach) {
  for (const bool smooth : {false, true}) {
    TetMesh mesh = cube_mesh(3);
    if (smooth)
      fill_with_smooth_tensors(mesh, 20240806, 4, 2);
    else
      fill_with_normal_tensors(mesh, 20240805);
    mesh.tensors[21] = {2, 2, 2, 0, 0, 0};
    const PreparedField<double> field(mesh);
    Share share(2);
    for (const char* mode : kLevels) {
      if (!share.has("mode")) continue;
      const auto value = ModeValue::parse(mode);
      const auto alone = extract_mode_surface<double>(mesh, value);
      const auto shared = extract_mode_surface(field, value);
      EXPECT_EQ(alone.surface.triangles, shared.surface.triangles) << mode;
      EXPECT_EQ(alone.surface.points.size(), shared.surface.points.size()) << mode;
      EXPECT_EQ(alone.unresolved.size(), shared.unresolved.size()) << mode;
      for (std::size_t v = 0; v < alone.surface.points.size(); ++v) {
        EXPECT_EQ(alone.surface.points[v].x, shared.surface.points[v].x);
        EXPECT_EQ(alone.surface.points[v].y, shared.surface.points[v].y);
        EXPECT_EQ(alone.surface.points[v].z, shared.surface.points[v].z);
      }
    }
  }
}

TEST(Extraction, FillsEveryArrayOfTheSurface) {
  TetMesh mesh = cube_mesh(1);
  fill_with_normal_tensors(mesh, 20240804);
  const SurfaceMesh surface = extract(mesh, "1/2").surface;
  const std::size_t vertices = surface.points.size(), triangles = surface.triangles.size();
  EXPECT_GT(triangles, 0u);
  EXPECT_EQ(surface.carrier.size(), vertices);
  EXPECT_EQ(surface.carrier_id.size(), vertices);
  EXPECT_EQ(surface.carrier_vertices.size(), vertices);
  EXPECT_EQ(surface.medium_eigenvector.size(), vertices);
  EXPECT_EQ(surface.dominant_eigenvector.size(), vertices);
  EXPECT_EQ(surface.normal.size(), vertices);
  EXPECT_EQ(surface.mode.size(), vertices);
  EXPECT_EQ(surface.residual.size(), vertices);
  EXPECT_EQ(surface.tet.size(), triangles);
  EXPECT_EQ(surface.component.size(), triangles);
}

TEST(Extraction, OfNothingIsEmpty) {
  const Extraction extraction = extract(TetMesh{}, "1/2");
  EXPECT_TRUE(extraction.surface.points.empty());
  EXPECT_TRUE(extraction.surface.triangles.empty());
  EXPECT_TRUE(extraction.unresolved.empty());
}

template <class Value>
bool same_bits(const std::vector<Value>& p, const std::vector<Value>& q) {
  return p.size() == q.size() &&
         (p.empty() || std::memcmp(p.data(), q.data(), p.size() * sizeof(Value)) == 0);
}

bool same_bits(const SurfaceMesh& p, const SurfaceMesh& q) {
  return same_bits(p.points, q.points) && same_bits(p.triangles, q.triangles) &&
         same_bits(p.carrier, q.carrier) && same_bits(p.carrier_id, q.carrier_id) &&
         same_bits(p.carrier_vertices, q.carrier_vertices) &&
         same_bits(p.medium_eigenvector, q.medium_eigenvector) &&
         same_bits(p.dominant_eigenvector, q.dominant_eigenvector) &&
         same_bits(p.normal, q.normal) && same_bits(p.mode, q.mode) &&
         same_bits(p.residual, q.residual) && same_bits(p.tet, q.tet) &&
         same_bits(p.component, q.component);
}

TEST(Extraction, HasTheSameBitsWithOneThreadAndWithTwo) {
  const std::uint64_t seed = 20240805;
  SCOPED_TRACE(announce(seed));
  for (const char* mode : {"1/10", "-1/2", "9/10"})
    for (const bool smooth : {false, true}) {
      TetMesh mesh = cube_mesh(smooth ? 8 : full_or_short(3, 2));
      if (smooth)
        fill_with_smooth_tensors(mesh, seed);
      else
        fill_with_normal_tensors(mesh, seed);
      const auto with_threads = [&](std::size_t count) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, count);
        return extract(mesh, mode).surface;
      };
      const SurfaceMesh one = with_threads(1), two = with_threads(2), again = with_threads(2);
      EXPECT_GT(one.triangles.size(), 100u);
      EXPECT_TRUE(same_bits(one, two)) << "mode " << mode;
      EXPECT_TRUE(same_bits(two, again)) << "mode " << mode;
    }
}

TEST(Extraction, StatisticsAddUp) {
  TetMesh mesh = cube_mesh(4);
  fill_with_smooth_tensors(mesh, 20240806);
  for (const char* mode : kLevels) {
    const Extraction extraction = extract(mesh, mode);
    const auto& s = extraction.statistics;
    EXPECT_LE(s.tets_screened_out + s.tets_crossed, mesh.tets.size());
    EXPECT_EQ(s.tets_crossed, s.tets_monotone + s.tets_refined);
    EXPECT_GE(s.sheets_small + s.sheets_bisected + s.sheets_tubes + s.sheets_graph +
                  s.sheets_manifold + s.sheets_dominant + s.sheets_subdivision + s.sheets_loops,
              s.tets_crossed);
    std::vector<SurfaceMesh::Index> tets = extraction.surface.tet;
    tets.erase(std::unique(tets.begin(), tets.end()), tets.end());
    EXPECT_EQ(s.tets_crossed, tets.size());
    EXPECT_EQ(s.vertices_on_level, 0u);
  }
}

TEST(Extraction, ReportsProgressFromZeroToOne) {
  TetMesh mesh = cube_mesh(2);
  fill_with_smooth_tensors(mesh, 20240807);
  ExtractOptions options;
  std::vector<double> fractions;
  options.progress = [&](std::string_view stage, double fraction) {
    EXPECT_FALSE(stage.empty());
    fractions.push_back(fraction);
  };
  extract_mode_surface<double>(mesh, ModeValue::parse("1/2"), options);
  ASSERT_FALSE(fractions.empty());
  for (const double f : fractions) EXPECT_TRUE(f >= 0 && f <= 1) << f;
}

// A finer sampling changes no topology.
TEST(Extraction, TopologyDoesNotDependOnTheSampling) {
  const std::uint64_t seed = 20240808;
  SCOPED_TRACE(announce(seed));
  for (const char* mode : {"1/10", "-1/2", "9/10", "-99/100"}) {
    TetMesh mesh = cube_mesh(2);
    fill_with_smooth_tensors(mesh, seed);
    const SurfaceSummary usual = summary(extract(mesh, mode).surface);
    for (const double resolution : {0.5, 2.0, 20.0}) {
      ExtractOptions options;
      options.sampling.resolution = resolution;
      const Extraction other = extract_mode_surface<double>(mesh, ModeValue::parse(mode), options);
      EXPECT_EQ(summary(other.surface), usual) << mode << " with resolution " << resolution;
      EXPECT_EQ(flaws(other, mesh), "") << mode << " with resolution " << resolution;
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
