// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "extract/cases/extract_case.hpp"
#include "extract/cases/strata_laws.hpp"
#include "support/oracles/brute_force.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

template <class Scalar>
void expect_stated_topology(const FieldWitness& witness, const TetCase& tet) {
  SCOPED_TRACE(witness.name + " at " + mode_of(tet.mode).text());
  const TetMesh mesh = single_tet_mesh(tet.points, witness.field.at(tet.points));
  const Extraction extraction = extract<Scalar>(mesh, mode_of(tet.mode).text());
  EXPECT_EQ(unresolved_text(extraction), "");
  const LocalTopology seen = topology_in_tet(extraction);
  EXPECT_EQ(seen.components, tet.components);
  EXPECT_EQ(seen.crossings(), tet.edge_crossings);
  EXPECT_EQ(flaws(extraction, mesh), "");
}

TEST(FieldWitness, HasTheTopologyStated) {
  for (const auto& witness : field_witnesses())
    for (const auto& tet : witness.cases) expect_stated_topology<double>(witness, tet);
}

TEST(FieldWitness, HasTheTopologyStatedAtFiftyDigits) {
  for (const auto& witness : field_witnesses()) {
    const TetCase* last = nullptr;
    for (const auto& tet : witness.cases)
      if (!tet.thin) last = &tet;
    expect_stated_topology<Real50>(witness, *last);
  }
}

TEST(FieldWitness, TurnsIntoItsMirrorImageWhenTensorsAndModeAreNegated) {
  for (const auto& witness : field_witnesses())
    for (const auto& tet : witness.cases) {
      SCOPED_TRACE(witness.name + " at " + mode_of(tet.mode).text());
      auto tensors = witness.field.at(tet.points);
      for (auto& t : tensors) t = -1.0 * t;
      const auto seen = topology_in_tet(
          extract(single_tet_mesh(tet.points, tensors), mode_of(tet.mode).opposite().text()));
      EXPECT_EQ(seen.components, tet.components);
      EXPECT_EQ(seen.crossings(), tet.edge_crossings);
    }
}

// Whether entries are integers so short that turning them is exact.
bool is_short(const SymmetricTensor<double>& t) {
  for (const double entry : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz})
    if (std::abs(entry) > 0x1p36 || entry != std::round(entry)) return false;
  return true;
}

/// The same linear field in another frame and other units: tensors turned and scaled by a power of
/// two, each, and points moved by an affine map.
TetMesh in_another_frame(TetMesh mesh, Random& random) {
  const auto q = random.quaternion();
  const int exponent = random.integer(-300, 300);
  for (auto& t : mesh.tensors) {
    EXPECT_TRUE(is_short(t)) << exact_text(t);
    t = std::ldexp(1.0, exponent + random.integer(-2, 2)) * turned(t, q);
  }
  const AffineMap map = random_affine_map(random);
  for (auto& p : mesh.points) p = map(p);
  return mesh;
}

TEST(FieldWitness, HasTheTopologyStatedInOtherFramesAndUnits) {
  Random random(20240110);
  for (const auto& witness : field_witnesses())
    for (const auto& tet : witness.cases) {
      SCOPED_TRACE(witness.name + " at " + mode_of(tet.mode).text());
      const TetMesh mesh =
          in_another_frame(single_tet_mesh(tet.points, witness.field.at(tet.points)), random);
      const Extraction extraction = extract(mesh, mode_of(tet.mode).text());
      EXPECT_EQ(unresolved_text(extraction), "");
      const LocalTopology seen = topology_in_tet(extraction);
      EXPECT_EQ(seen.components, tet.components);
      EXPECT_EQ(seen.crossings(), tet.edge_crossings);
    }
}

TEST(StratumWitness, IsTheSameInOtherFramesAndUnits) {
  Random random(20240111);
  for (const auto& witness : stratum_witnesses())
    for (const char* mode : {"0", "1/10", "-1/2", "-143/343", "9/10", "-99/100"}) {
      SCOPED_TRACE(witness.name + " at " + mode);
      const TetMesh mesh = single_tet_mesh(witness.points, witness.tensors);
      EXPECT_EQ(outcome(extract(in_another_frame(mesh, random), mode)),
                outcome(extract(mesh, mode)));
    }
}

// At mode 0 the witnesses state nothing: brute force does, where it resolves the surface.
TEST(FieldWitness, HasTheNeutralSurfaceThatBruteForceSees) {
  int decided = 0;
  for (const auto& witness : field_witnesses())
    for (std::size_t i = 0; i < witness.cases.size(); ++i) {
      const auto& tet = witness.cases[i];
      if (i > 0 && tet.points == witness.cases[i - 1].points) continue;
      SCOPED_TRACE(witness.name);
      const auto tensors = witness.field.at(tet.points);
      const TetMesh mesh = single_tet_mesh(tet.points, tensors);
      const Extraction extraction = extract(mesh, "0");
      EXPECT_EQ(flaws(extraction, mesh), "");
      if (!extraction.unresolved.empty()) {
        // Two singular lines that coincide; two planes that meet an edge along it.
        EXPECT_EQ(std::string(name_of(extraction.unresolved[0].reason)),
                  witness.name == "uniaxial_complement" ? "critical_value_in_cell"
                  : witness.name == "cylinders"         ? "level_constant_on_edge"
                                                        : "")
            << witness.name;
        continue;
      }
      const auto expected = brute_force_topology(corners_of(tensors), 0);
      if (!expected) continue;
      ++decided;
      EXPECT_EQ(topology_in_tet(extraction), *expected);
    }
  EXPECT_GT(decided, 5);
}

// At the saddle value the surface has a cone point inside; by the rule mu + 0 it is cut as above.
TEST(FieldWitness, CriticalLevelsAreThoseOfLargerModes) {
  const auto& witness = field_witness("saddle_origin_rational");
  const auto& points = witness.cases[0].points;
  const TetMesh mesh = single_tet_mesh(points, witness.field.at(points));
  const Extraction extraction = extract(mesh, "-143/343");
  EXPECT_EQ(unresolved_text(extraction), "");
  EXPECT_EQ(extraction.statistics.tets_nearby, 1u);
  EXPECT_EQ(topology_in_tet(extraction).components, (std::vector<ComponentTopology>{annulus}));
}

// A level within 1e-6 of the saddle value still has its proof, on either side.
TEST(FieldWitness, LevelsCloseToCriticalAreDecided) {
  const auto& witness = field_witness("saddle_origin_rational");
  const auto& points = witness.cases[0].points;
  const TetMesh mesh = single_tet_mesh(points, witness.field.at(points));
  const Extraction above = extract(mesh, "-4169095/10000000"),  // critical: -0.41690962...
      below = extract(mesh, "-4169105/10000000");
  EXPECT_EQ(unresolved_text(above), "");
  EXPECT_EQ(unresolved_text(below), "");
  EXPECT_EQ(topology_in_tet(above).components, (std::vector<ComponentTopology>{annulus}));
  EXPECT_EQ(topology_in_tet(below).components, (std::vector<ComponentTopology>{disc, disc}));
}

// Special position is either named or extracted as brute force sees it.
TEST(StratumWitness, IsNamedOrExtractedRight) {
  for (const auto& witness : stratum_witnesses()) {
    const TetMesh mesh = single_tet_mesh(witness.points, witness.tensors);
    for (const char* mode : {"1/10", "-1/2", "9/10", "-99/100"}) {
      SCOPED_TRACE(witness.name + " at " + mode);
      const Extraction extraction = extract(mesh, mode);
      EXPECT_EQ(flaws(extraction, mesh), "");
      if (!extraction.unresolved.empty()) {
        EXPECT_TRUE(witness.zero_point) << unresolved_text(extraction);
        EXPECT_TRUE(extraction.surface.triangles.empty());
        continue;
      }
      const auto expected =
          brute_force_topology(corners_of(witness.tensors), ModeValue::parse(mode).approx());
      if (expected) {
        EXPECT_EQ(topology_in_tet(extraction), *expected);
      }
    }
  }
}

TEST(StratumWitness, ZeroDeviatorsAtVerticesAreResolved) {
  for (const char* name : {"one_direction", "zero", "zero_vertex"}) {
    const auto& witness = stratum_witness(name);
    const TetMesh mesh = single_tet_mesh(witness.points, witness.tensors);
    for (const char* mode : kLevels) {
      SCOPED_TRACE(std::string(name) + " at " + mode);
      const Extraction extraction = extract(mesh, mode);
      EXPECT_EQ(flaws(extraction, mesh), "");
      EXPECT_GE(extraction.statistics.zero_deviator_vertices, 1u);
      // Neutral everywhere on its level is something else.
      const bool on_level = ModeValue::parse(mode).sign() == 0 && witness.constant_mode;
      if (!on_level) {
        EXPECT_EQ(unresolved_text(extraction), "");
      }
      for (const auto& cell : extraction.unresolved)
        EXPECT_EQ(cell.reason, UnresolvedReason::level_constant_in_cell);
    }
  }
}

TEST(StratumWitness, ConstantModeIsEmptyBesideItsLevelAndNamedOnIt) {
  const auto& witness = stratum_witness("constant");
  const TetMesh mesh = single_tet_mesh(witness.points, witness.tensors);
  for (const char* mode : {"-41690/100000", "-41692/100000", "-1/10", "1/2"}) {
    const Extraction beside = extract(mesh, mode);
    EXPECT_EQ(unresolved_text(beside), "") << mode;
    EXPECT_TRUE(beside.surface.triangles.empty()) << mode;
    EXPECT_EQ(beside.statistics.vertices_on_level, 0u) << mode;
  }
  const Extraction on = extract(mesh, "-143/343");
  EXPECT_EQ(on.statistics.vertices_on_level, 4u);
  ASSERT_EQ(on.unresolved.size(), 1u);
  EXPECT_EQ(on.unresolved[0].reason, UnresolvedReason::level_constant_in_cell);
  EXPECT_TRUE(on.surface.triangles.empty());
}

// Determinant zero identically: neutral everywhere, so nothing at any other mode.
TEST(StratumWitness, AntiplaneShearIsNeutralEverywhere) {
  const auto& witness = stratum_witness("antiplane_shear");
  const TetMesh mesh = single_tet_mesh(witness.points, witness.tensors);
  for (const char* mode : kLevels) {
    const Extraction extraction = extract(mesh, mode);
    EXPECT_TRUE(extraction.surface.triangles.empty()) << mode;
    if (ModeValue::parse(mode).sign() != 0) {
      EXPECT_EQ(unresolved_text(extraction), "") << mode;
      continue;
    }
    ASSERT_EQ(extraction.unresolved.size(), 1u);
    EXPECT_EQ(extraction.unresolved[0].reason, UnresolvedReason::level_constant_in_cell);
  }
}

// The level is mu + 0: a vertex on mu counts as below, so the surface is that of a mode just above.
TEST(StratumWitness, VertexOnTheLevelCountsAsBelow) {
  const auto& witness = stratum_witness("vertex_on_surface");
  const TetMesh mesh = single_tet_mesh(witness.points, witness.tensors);
  const Extraction on = extract(mesh, "-143/343"), above = extract(mesh, "-416909/1000000");
  EXPECT_EQ(on.statistics.vertices_on_level, 1u);
  EXPECT_EQ(above.statistics.vertices_on_level, 0u);
  EXPECT_EQ(unresolved_text(on), "");
  EXPECT_EQ(topology_in_tet(on), topology_in_tet(above));
  EXPECT_EQ(flaws(on, mesh, {.residuals = true, .coincidences = false}), "");
}

}  // namespace
}  // namespace tensortopo::test
