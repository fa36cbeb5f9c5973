// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include "extract/cases/curve_checks.hpp"
#include "extract/cases/extract_case.hpp"
#include "support/fields/strata_fields.hpp"
#include "support/fields/witness_fields.hpp"

// Laws of degenerate curves in special position.

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

/// Meshes full of ties, planes of symmetry and deficient ranks.
TetMesh special_mesh(int trial, Random& random) {
  TetMesh mesh = cube_mesh(2);
  // Away from 0, where doubles are denser than what places are computed in.
  for (auto& p : mesh.points) p = p + Vector3<double>{4, 4, 4};
  const int bound = 1 + trial % 4;
  for (auto& t : mesh.tensors) {
    for (double* entry : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz})
      *entry = random.integer(-bound, bound);
    // No further isotropic vertices: between two of them there is no mode either.
    if (deviator(t) == Deviator<double>{}) t.xy = 1;
    if (trial % 5 == 1) t.xz = t.yz = 0;  // plane strain
  }
  if (trial % 5 == 2)  // a mirror in the middle
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (mesh.points[v].z == 5) mesh.tensors[v].xz = mesh.tensors[v].yz = 0;
  // Tensors that commute, with eigenvectors of the third degree.
  const SymmetricTensor<double> m{1, 1, -2, 1, 1, 0}, square{2, 3, 5, 2, -1, 1};
  if (trial % 5 == 4)
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (mesh.points[v].z == 5)
        mesh.tensors[v] = random.integer(-bound, bound) * m + random.integer(1, 3) * square;
  if (trial % 5 == 3) mesh.tensors[13] = {7, 7, 7, 0, 0, 0};  // no deviator in the middle
  return mesh;
}

std::map<std::string_view, int> names(const CurveExtraction& extraction) {
  std::map<std::string_view, int> result;
  for (const auto& cell : extraction.unresolved) ++result[name_of(cell.obstacle)];
  return result;
}

TEST(SpecialCurves, AreFlawlessAndCompleteButForSurfaces) {
  const std::uint64_t seed = 20250111;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  std::map<Carrier, int> carriers;
  std::size_t surfaces = 0;
  for (int trial = 0; trial < trials(20, 10); ++trial) {
    const TetMesh mesh = special_mesh(trial, random);
    for (const Degeneracy kind : kKinds) {
      const auto extraction = extract_degenerate_curves(mesh, kind);
      EXPECT_EQ(flaws(extraction, mesh, mode_of(kind), CurveEnds::free), "") << "trial " << trial;
      for (const Carrier carrier : extraction.curves.carrier) ++carriers[carrier];
      for (const auto& cell : extraction.unresolved)
        EXPECT_EQ(cell.obstacle, CurveObstacle::degenerate_on_a_surface);
      surfaces += extraction.unresolved.size();
    }
  }
  EXPECT_GT(carriers[Carrier::vertex], 10);
  EXPECT_GT(carriers[Carrier::edge], 10);
  EXPECT_GT(surfaces, 10u);
}

// Degenerate tensors are a closed set: where the curves of fields close to this one run, there must
// be curves of this one, or an isolated point, around which they are short.
TEST(SpecialCurves, AreWhereTheCurvesOfNearbyGeneralFieldsRun) {
  const std::uint64_t seed = 20250112;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  ExtractOptions options;
  options.sampling.resolution = 40;
  std::size_t compared = 0;
  for (int trial = 0; trial < trials(15); ++trial) {
    const TetMesh mesh = special_mesh(trial, random);
    TetMesh near = mesh;
    for (auto& t : near.tensors) t = t + std::ldexp(1.0, -44) * random.tensor();
    for (const Degeneracy kind : kKinds) {
      const auto exact = extract_degenerate_curves(mesh, kind, options);
      if (!exact.unresolved.empty()) continue;
      const auto nearby = extract_degenerate_curves(near, kind, options);
      EXPECT_TRUE(nearby.unresolved.empty());
      // Nearly dependent tensors on a face leave places fewer digits than the check asks for.
      if (trial % 5 != 4) {
        EXPECT_EQ(flaws(nearby, near, mode_of(kind)), "") << "trial " << trial;
      }
      for (const auto& [component, away] : away_from(exact.curves, nearby.curves)) {
        EXPECT_TRUE(away.distance < 0.02 || away.length < 0.02)
            << "trial " << trial << ", mode " << mode_of(kind) << ", away by " << away.distance;
        ++compared;
      }
    }
  }
  std::cout << compared << " components\n";
  EXPECT_GT(compared, 50u);
}

using Shape = std::array<std::size_t, 4>;

Shape shape(const CurveExtraction& extraction) {
  const auto known = curve_invariants(extraction.curves);
  return {extraction.curves.lines.size(), known.components, known.closed_components,
          extraction.unresolved.size()};
}

TEST(SpecialCurves, KeepTheirShape) {
  const std::uint64_t seed = 20250113;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (int trial = 0; trial < trials(5); ++trial) {
    const TetMesh mesh = special_mesh(trial, random);
    const std::size_t n = mesh.points.size();
    TetMesh turned = mesh, scaled = mesh, renumbered = mesh;
    const auto q = random.quaternion();
    for (auto& t : turned.tensors) t = tensortopo::turned(t, q);
    for (auto& t : scaled.tensors) t = std::ldexp(1.0, random.integer(-100, 100)) * t;
    for (std::size_t v = 0; v < n; ++v) {
      renumbered.points[n - 1 - v] = mesh.points[v];
      renumbered.tensors[n - 1 - v] = mesh.tensors[v];
    }
    for (auto& tet : renumbered.tets)
      for (Index& v : tet) v = static_cast<Index>(n) - 1 - v;
    TetMesh opposite = mesh;
    for (auto& t : opposite.tensors) t = -1.0 * t;
    for (const Degeneracy kind : kKinds) {
      const Degeneracy other = kind == Degeneracy::linear ? Degeneracy::planar : Degeneracy::linear;
      const auto expected = extract_degenerate_curves(mesh, kind);
      for (const auto& [changed, of] :
           {std::pair{&turned, kind}, std::pair{&scaled, kind}, std::pair{&renumbered, kind},
            std::pair{&opposite, other}}) {
        const auto extraction = extract_degenerate_curves(*changed, of);
        EXPECT_EQ(shape(extraction), shape(expected)) << "trial " << trial;
        EXPECT_EQ(names(extraction), names(expected)) << "trial " << trial;
      }
    }
  }
}

// Each degenerate configuration of fields in one tetrahedron.
TEST(SpecialCurves, OfEachStratumAreFlawlessAndComplete) {
  const std::uint64_t seed = 20250114;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (const Stratum stratum : all_strata())
    for (int trial = 0; trial < trials(20); ++trial) {
      const TetMesh mesh = reference_tet_mesh(stratum_tensors(stratum, random));
      for (const Degeneracy kind : kKinds) {
        const auto extraction = extract_degenerate_curves(mesh, kind);
        EXPECT_EQ(flaws(extraction, mesh, mode_of(kind), CurveEnds::free), "") << name_of(stratum);
        for (const auto& cell : extraction.unresolved)
          EXPECT_NE(cell.obstacle, CurveObstacle::points_not_told_apart) << name_of(stratum);
        // Only two independent tensors or fewer, or a common eigenvector, make more than curves.
        const bool may_have_more =
            stratum == Stratum::rank_zero || stratum == Stratum::rank_one ||
            stratum == Stratum::rank_two || stratum == Stratum::two_zero_vertices ||
            stratum == Stratum::three_zero_vertices || stratum == Stratum::plane_strain ||
            stratum == Stratum::antiplane_shear || stratum == Stratum::constant_cell;
        EXPECT_TRUE(may_have_more || extraction.unresolved.empty()) << name_of(stratum);
        for (const auto& cell : extraction.unresolved)
          EXPECT_EQ(stratum == Stratum::rank_zero,
                    cell.obstacle == CurveObstacle::no_deviator_in_cell);
      }
    }
}

TEST(SpecialCurves, OfWitnessesAreFlawless) {
  for (const auto& witness : stratum_witnesses())
    for (const Degeneracy kind : kKinds) {
      const TetMesh mesh = single_tet_mesh(witness.points, witness.tensors);
      const auto extraction = extract_degenerate_curves(mesh, kind);
      EXPECT_EQ(flaws(extraction, mesh, mode_of(kind), CurveEnds::free), "") << witness.name;
      EXPECT_TRUE(witness.rank > 2 || extraction.curves.lines.empty()) << witness.name;
    }
}

}  // namespace
}  // namespace tensortopo::test
