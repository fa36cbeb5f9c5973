// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Fields that are one tensor times a scalar, but for a small rest: the stress of a bent beam.
// Around the scalar's zeros, and only there, the rest decides. And the stress of a twisted shaft,
// of rank two, with mode 0 throughout: there the rest decides on the neutral surface everywhere.
#include <gtest/gtest.h>

#include "extract/cases/extract_case.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

/// A beam along x that is bent: stress xx in proportion to the height above the neutral layer, and
/// the same small tensors besides, times `rest`.
TetMesh bent_beam(int cubes, double rest, std::uint64_t seed) {
  TetMesh mesh = cube_mesh(cubes);
  Random random(seed);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& p = mesh.points[v];
    const SymmetricTensor<double> tension{
        (p.z - 0.97) * (1 + 0.1 * p.x) + 0.03 * p.y, 0, 0, 0, 0, 0};
    mesh.tensors[v] = tension + rest * random.tensor();
  }
  return mesh;
}

class BentBeam : public testing::TestWithParam<const char*> {};

/// In the layer the field is that of lengths measured in the rest's own size: the surface is the
/// same, however thin the layer, once it is thin.
TEST_P(BentBeam, HasOneTopologyHoweverThinItsNeutralLayer) {
  constexpr std::uint64_t seed = 20241202;
  SCOPED_TRACE(announce(seed));
  const SurfaceSummary expected = summary(extract(bent_beam(2, 1e-5, seed), GetParam()).surface);
  EXPECT_GT(expected.on_edges, 20u);
  for (const double rest : full_or_short<std::vector<double>>({1e-6, 1e-14}, {1e-14})) {
    const TetMesh mesh = bent_beam(2, rest, seed);
    const Extraction extraction = extract(mesh, GetParam());
    EXPECT_EQ(unresolved_text(extraction), "") << rest;
    // Across so thin a layer the last bits of coordinates are much of the mode.
    EXPECT_EQ(flaws(extraction, mesh, {.residuals = false, .coincidences = rest > 1e-9}), "")
        << rest;
    EXPECT_EQ(summary(extraction.surface), expected) << rest;
  }
}

TEST_P(BentBeam, HasTheSameTopologyInTwoPrecisions) {
  constexpr std::uint64_t seed = 20241203;
  SCOPED_TRACE(announce(seed));
  for (const double rest : {1e-7, 1e-13}) {
    const TetMesh mesh = bent_beam(1, rest, seed);
    const Extraction plain = extract(mesh, GetParam()), precise = extract<Real50>(mesh, GetParam());
    EXPECT_EQ(unresolved_text(precise), "") << rest;
    EXPECT_EQ(summary(plain.surface), summary(precise.surface)) << rest;
  }
}

/// A shaft along z that is twisted about an axis beside it, and the same small tensors besides,
/// times `rest`.
TetMesh twisted_shaft(int cubes, double rest, std::uint64_t seed) {
  TetMesh mesh = cube_mesh(cubes);
  Random random(seed);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& p = mesh.points[v];
    const SymmetricTensor<double> twist{0, 0, 0, 0, p.x + 0.43, -0.57 - p.y};
    mesh.tensors[v] = twist + rest * random.tensor();
  }
  return mesh;
}

/// To first order in the rest the neutral surface does not depend on its size. Its medium
/// eigenvectors do: they are that close to a curve.
TEST(TwistedShaft, HasOneNeutralSurfaceHoweverSmallTheRest) {
  constexpr std::uint64_t seed = 20241204;
  SCOPED_TRACE(announce(seed));
  const SurfaceMesh coarse = extract(twisted_shaft(2, 1e-3, seed), "0").surface;
  EXPECT_GT(summary(coarse).on_edges, 20u);
  for (const double rest : {1e-6, 1e-9, 1e-11}) {
    const TetMesh mesh = twisted_shaft(2, rest, seed);
    const Extraction extraction = extract(mesh, "0");
    EXPECT_EQ(unresolved_text(extraction), "") << rest;
    EXPECT_EQ(flaws(extraction, mesh, {.residuals = false}), "") << rest;
    EXPECT_EQ(summary(extraction.surface), summary(coarse)) << rest;
    EXPECT_LE(extraction.surface.triangles.size(), 2 * coarse.triangles.size()) << rest;
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, BentBeam, testing::Values("0", "1/2", "-9/10", "99/100"));

}  // namespace
}  // namespace tensortopo::test
