// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <sstream>

#include "extract/cases/strata_laws.hpp"
#include "support/oracles/brute_force.hpp"
#include "support/compared.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

// The reasons that a degenerate configuration may give, at its level and at others.
std::set<std::string> reasons_of(Stratum stratum, bool at_special_mode) {
  switch (stratum) {
    case Stratum::cone_apex_inside:
    case Stratum::zero_on_face:
    case Stratum::zero_on_edge:
      return {"zero_deviator_inside"};
    case Stratum::antiplane_shear:
      if (at_special_mode) return {"zero_deviator_inside", "level_constant_in_cell"};
      return {"zero_deviator_inside"};
    case Stratum::rank_two:
    case Stratum::rank_one:
      return {"zero_deviator_inside", "level_constant_in_cell"};
    case Stratum::plane_strain:
      return {"zero_deviator_inside"};  // four tensors in three dimensions, often zero among them
    case Stratum::uniaxial_complement:
    case Stratum::face_saddle:  // whose complement can be uniaxial
      // A whole line of saddles: next to it sheets are close to each other all along.
      if (at_special_mode) return {"critical_value_in_cell"};
      return {};
    case Stratum::constant_edge:
      if (at_special_mode) return {"level_constant_on_edge"};
      return {};
    case Stratum::constant_face:
      if (at_special_mode) return {"level_constant_on_face"};
      return {};
    case Stratum::constant_cell:
      if (at_special_mode) return {"level_constant_in_cell"};
      return {};
    default:
      return {};
  }
}

/// Whether there is a level to compare: brute force sees nothing of critical levels, and vertices
/// without deviator have tests of their own.
bool is_seen_by_brute_force(Stratum stratum) {
  switch (stratum) {
    case Stratum::cone_apex_inside:
    case Stratum::zero_on_face:
    case Stratum::zero_on_edge:
    case Stratum::rank_one:
    case Stratum::rank_zero:
    case Stratum::zero_vertex:
    case Stratum::two_zero_vertices:
    case Stratum::three_zero_vertices:
    case Stratum::plane_strain:
    case Stratum::face_saddle:
      return false;
    default:
      return true;
  }
}

class Strata : public testing::TestWithParam<Stratum> {
 protected:
  // Calls a check with tensors and level, for some tensors at all levels.
  void for_each_case(std::uint64_t seed, int count,
                     const std::function<void(const TetTensors&, const std::string&)>& check) {
    SCOPED_TRACE(announce(seed));
    for (int trial = 0; trial < trials(count); ++trial) {
      Random random(seed + static_cast<std::uint64_t>(trial));
      const TetTensors tensors = stratum_tensors(GetParam(), random);
      for (const auto& mode : modes_for(GetParam())) {
        SCOPED_TRACE("at " + mode + '\n' + exact_text(tensors));
        check(tensors, mode);
      }
    }
  }
};

TEST_P(Strata, GiveFlawlessSurfacesOrTheirOwnReason) {
  for_each_case(20241201, 8, [&](const TetTensors& tensors, const std::string& mode) {
    const TetMesh mesh = reference_tet_mesh(tensors);
    const Extraction extraction = extract(mesh, mode);
    const bool on_level = extraction.statistics.vertices_on_level > 0;
    EXPECT_EQ(flaws(extraction, mesh, {.residuals = true, .coincidences = !on_level}), "");
    if (extraction.unresolved.empty()) return;
    const std::string reason = outcome(extraction).reason;
    // Small integers meet other strata by chance: vertices on the level, a uniaxial complement.
    if (mode != special_mode(GetParam()) && (on_level || mode == "0")) return;
    if (reason == "critical_value_in_cell" && GetParam() == Stratum::face_saddle) return;
    EXPECT_TRUE(reasons_of(GetParam(), mode == special_mode(GetParam())).contains(reason))
        << reason;
  });
}

TEST_P(Strata, AreTheSameAtFiftyDigits) {
  for_each_case(20241202, 2, [&](const TetTensors& tensors, const std::string& mode) {
    const TetMesh mesh = reference_tet_mesh(tensors);
    EXPECT_EQ(outcome(extract<Real50>(mesh, mode)), outcome(extract(mesh, mode)));
  });
}

// What is of the level asked for throughout has no surface: it is named, never left out silently.
TEST(LevelThroughout, IsNamed) {
  for (const Stratum stratum : {Stratum::antiplane_shear, Stratum::constant_edge,
                                Stratum::constant_face, Stratum::constant_cell})
    for (int trial = 0; trial < trials(6); ++trial) {
      Random random(20241217 + static_cast<std::uint64_t>(trial));
      const TetTensors tensors = stratum_tensors(stratum, random);
      SCOPED_TRACE(name_of(stratum) + '\n' + exact_text(tensors));
      const std::string mode = special_mode(stratum);
      const std::string reason = outcome(extract(reference_tet_mesh(tensors), mode)).reason;
      EXPECT_TRUE(reasons_of(stratum, true).contains(reason)) << reason;
    }
}

// Strata with a mode of their own, but for those that have it throughout (`LevelThroughout`).
class StrataAtTheirMode : public testing::TestWithParam<Stratum> {};

// The level is mu + 0. None of these tetrahedra has another critical value so close to its own.
TEST_P(StrataAtTheirMode, HaveTheTopologyOfASlightlyLargerMode) {
  const std::string special = special_mode(GetParam());
  const std::string larger = special == "0"         ? "1/100000000"
                             : special == "4/5"     ? "0.80000001"
                             : special == "143/343" ? "0.41690963"
                                                    : "-0.41690961";
  int compared = 0;
  for (int trial = 0; trial < trials(6); ++trial) {
    Random random(20241210 + static_cast<std::uint64_t>(trial));
    const TetTensors tensors = stratum_tensors(GetParam(), random);
    SCOPED_TRACE(exact_text(tensors));
    const TetMesh mesh = reference_tet_mesh(tensors);
    const Outcome at = outcome(extract(mesh, special)), after = outcome(extract(mesh, larger));
    if (!at.reason.empty() || !after.reason.empty()) continue;
    EXPECT_EQ(at, after);
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

// Turning all tensors, scaling each by its own power of two, moving the points by an affine map:
// others in each case.
TEST_P(Strata, AreTheSameInOtherFramesAndUnits) {
  Compared compared("fields");
  Random random(20241204);
  for_each_case(20241203, 3, [&](const TetTensors& tensors, const std::string& mode) {
    const Outcome before = outcome(extract(reference_tet_mesh(tensors), mode));
    const auto q = random.quaternion();
    const int exponent = random.integer(-200, 200);
    std::array<int, 4> exponents;
    for (int& e : exponents) e = random.integer(-2, 2);
    const AffineMap map = random_affine_map(random);
    std::ostringstream patch;
    patch << "turned by";
    for (const int entry : q) patch << ' ' << entry;
    patch << ", scaled by 2^" << exponent << ", moved by " << map;
    SCOPED_TRACE(patch.str());
    if (before.reason == "inconsistent_samples") return;  // of samples, which scaling moves
    ++compared;
    TetTensors other = tensors;
    for (auto& t : other) t = turned(t, q);
    EXPECT_EQ(outcome(extract(reference_tet_mesh(other), mode)), before);
    other = tensors;
    for (auto& t : other) t = std::ldexp(1.0, exponent) * t;
    EXPECT_EQ(outcome(extract(reference_tet_mesh(other), mode)), before);
    other = tensors;
    for (std::size_t i = 0; i < 4; ++i) other[i] = std::ldexp(1.0, exponents[i]) * other[i];
    const Outcome scaled = outcome(extract(reference_tet_mesh(other), mode));
    if (scaled.reason != "inconsistent_samples") {
      EXPECT_EQ(scaled, before);
    }
    TetMesh moved = reference_tet_mesh(tensors);
    for (auto& p : moved.points) p = map(p);
    EXPECT_EQ(outcome(extract(moved, mode)), before);
  });
}

TEST_P(Strata, AreTheSameInAnyNumbering) {
  Compared compared("numberings");
  for_each_case(20241205, 2, [&](const TetTensors& tensors, const std::string& mode) {
    const Outcome before = outcome(extract(reference_tet_mesh(tensors), mode));
    if (before.reason == "inconsistent_samples") return;
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    for (int turn = 1; turn < 24; ++turn) {
      std::next_permutation(order.begin(), order.end());
      if (turn % 5 != 0) continue;
      TetTensors other;
      for (std::size_t i = 0; i < 4; ++i) other[i] = tensors[order[i]];
      const Outcome after = outcome(extract(reference_tet_mesh(other), mode));
      if (after.reason == "inconsistent_samples") continue;
      EXPECT_EQ(after, before);
      ++compared;
    }
  });
}

// One tetrahedron of a degenerate configuration among others: no hole that is not reported.
TEST_P(Strata, LeaveTheRestOfAMeshSound) {
  Random random(20241207);
  for_each_case(20241206, 2, [&](const TetTensors& tensors, const std::string& mode) {
    TetMesh mesh = cube_mesh(1);
    for (auto& t : mesh.tensors) t = rounded(8.0 * random.tensor(), 0);
    for (std::size_t i = 0; i < 4; ++i)
      mesh.tensors[static_cast<std::size_t>(mesh.tets[0][i])] = tensors[i];
    const Extraction extraction = extract(mesh, mode);
    const bool on_level = extraction.statistics.vertices_on_level > 0;
    const std::string found =
        flaws(extraction, mesh, {.residuals = false, .coincidences = !on_level});
    const bool is_manifold = surface_invariants(extraction.surface).manifold;
    if (extraction.unresolved.empty()) {
      EXPECT_EQ(found, "");
      EXPECT_TRUE(is_manifold);
      return;
    }
    // What is left out can leave two fans at a vertex: then the surface is not called a manifold.
    std::istringstream lines(found);
    for (std::string line; std::getline(lines, line);)
      EXPECT_EQ(line.rfind("vertex link", 0), 0u) << line;
    EXPECT_EQ(is_manifold, found.empty());
  });
}

TEST_P(Strata, HaveTheTopologyThatBruteForceSees) {
  Compared compared(name_of(GetParam()), is_seen_by_brute_force(GetParam()) ? 1 : 0);
  for_each_case(20241212, 1, [&](const TetTensors& tensors, const std::string& mode) {
    const Extraction extraction = extract(reference_tet_mesh(tensors), mode);
    const auto& known = extraction.statistics;
    // No lattice resolves a level at its critical value, through a vertex, or as near to mode 1;
    // isotropic vertices have tests of their own.
    if (!extraction.unresolved.empty() || known.vertices_on_level > 0) return;
    if (known.tets_nearby > 0 || known.zero_deviator_vertices > 0) return;
    const double level = ModeValue::parse(mode).approx();
    if (std::abs(level) > 0.99) return;
    const auto expected =
        brute_force_topology(corners_of(tensors), level, {.ladder = {{48, 64}, {96, 128}}});
    if (expected) {
      EXPECT_EQ(topology_in_tet(extraction), *expected);
      ++compared;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(All, Strata, testing::ValuesIn(all_strata()),
                         [](const auto& tested) { return name_of(tested.param); });
INSTANTIATE_TEST_SUITE_P(All, StrataAtTheirMode,
                         testing::Values(Stratum::uniaxial_complement, Stratum::vertex_on_level,
                                         Stratum::tangent_edge, Stratum::face_saddle,
                                         Stratum::tet_saddle, Stratum::face_minimum,
                                         Stratum::face_maximum),
                         [](const auto& tested) { return name_of(tested.param); });

TEST(NearStrata, TetrahedraAreSoundAndTheSameAtFiftyDigits) {
  expect_sound_near_strata(trials(100), 20, 20241208);
}

}  // namespace
}  // namespace tensortopo::test
