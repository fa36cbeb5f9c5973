// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/persistence/component_persistence.hpp"

namespace tensortopo::test {
namespace {

TetMesh noisy_cube_of(int n, std::uint64_t seed) {
  TetMesh mesh = cube_mesh(n);
  fill_with_normal_tensors(mesh, seed);
  return mesh;
}

// No component matters more than its level is away from modes 1 and -1;
// and whole components stay, with all their triangles.
TEST(ComponentPersistence, WholeComponentsStay) {
  Compared compared("components", 25), dropped("components left out", 5);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const TetMesh mesh = noisy_cube_of(2, seed);
    const PersistenceInput input = persistence_input(mesh);
    for (const char* mode : {"-0.8", "-0.5", "0.3", "0.6"}) {
      const SurfaceMesh surface =
          extract_mode_surface<double>(mesh, ModeValue::parse(mode)).surface;
      const double level = signed_lode_angle(std::stod(mode));
      const auto values = component_persistence(mesh, input, surface, std::stod(mode));
      const SurfaceInvariants all = surface_invariants(surface);
      ASSERT_EQ(values.size(), all.components);
      std::vector<char> keep(values.size(), 1);
      for (std::size_t c = 0; c < values.size(); ++c) {
        if (!values[c]) continue;
        ++compared;
        EXPECT_GT(*values[c], 0);
        EXPECT_LE(*values[c], std::numbers::pi / 6 - std::abs(level) + 1e-12);
        keep[c] = *values[c] > 0.2;
        dropped.count(keep[c] == 0);
      }
      const SurfaceInvariants some = surface_invariants(kept_components(surface, keep));
      EXPECT_EQ(some.components, static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 1)));
      std::size_t triangles = 0;
      for (const auto c : surface.component) triangles += keep[static_cast<std::size_t>(c)] != 0;
      EXPECT_EQ(kept_components(surface, keep).triangles.size(), triangles);
      EXPECT_EQ(some.manifold, all.manifold);
      EXPECT_LE(some.boundary_loops, all.boundary_loops);
    }
  }
}

// What is not proved on one side can hide nothing where the mode changes less on the other, and
// can be decisive elsewhere; values that are given are those that are known with all proofs.
TEST(ComponentPersistence, IsKnownWhereOnlyTheLargerChangeIsOpen) {
  Compared known("components with a value", 12), open("components without", 3);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const TetMesh mesh = noisy_cube_of(2, seed);
    const PersistenceInput proved = persistence_input(mesh);
    PersistenceInput below = proved, unresolved = proved;
    for (ModeMerge& merge : below.trees[1].merges) merge.is_proved = false, merge.possible.reset();
    unresolved.curves[0].unresolved.push_back({});
    for (const char* mode : {"-0.8", "-0.5", "0.3", "0.6", "0.9"}) {
      const SurfaceMesh surface =
          extract_mode_surface<double>(mesh, ModeValue::parse(mode)).surface;
      const double level = std::stod(mode);
      const auto expected = component_persistence(mesh, proved, surface, level);
      for (const PersistenceInput* input : {&below, &unresolved}) {
        const auto found = component_persistence(mesh, *input, surface, level);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t c = 0; c < found.size(); ++c) {
          if (!expected[c]) continue;
          (found[c] ? known : open).count(true);
          EXPECT_EQ(found[c].value_or(*expected[c]), *expected[c]) << seed << " at " << mode;
        }
      }
    }
  }
}

TEST(ComponentPersistence, WholeCurvesStay) {
  Compared compared("curves", 30);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const TetMesh mesh = noisy_cube_of(2, seed);
    const PersistenceInput input = persistence_input(mesh);
    const ModePersistence persistence = mode_persistence(mesh, input);
    const CurveMesh& curves = input.curves[0].curves;
    const CurveInvariants all = curve_invariants(curves);
    const auto values = curve_persistence(persistence, 1, all.components);
    std::vector<char> keep;
    double length = 0;
    for (std::size_t c = 0; c < values.size(); ++c) {
      ASSERT_TRUE(values[c].has_value());
      keep.push_back(*values[c] > 0.2);
      if (keep.back() != 0) length += input.trees[0].maxima[c].length;
      ++compared;
    }
    const CurveInvariants some = curve_invariants(kept_components(curves, keep));
    EXPECT_EQ(some.components, static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 1)));
    EXPECT_NEAR(some.length, length, 1e-9);
  }
}

}  // namespace
}  // namespace tensortopo::test
