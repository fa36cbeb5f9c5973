// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "brute_force.hpp"
#include "support/compared.hpp"
#include "support/fields/witness_fields.hpp"
#include "support/generators.hpp"
#include "support/trials.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::test {
namespace {

bool is_above(const SymmetricTensor<double>& t, double mode) {
  const std::array<ExactDeviator, 1> corner{ExactDeviator(t)};
  return LevelQuestion(corner, mode).is_above(std::array<std::int64_t, 1>{1});
}

TEST(LevelQuestion, SidesOfATensorOfKnownRationalMode) {
  const SymmetricTensor<double> t{11, 2, -13, 0, 0, 0};  // mode -143/343
  const double below = std::nextafter(-143.0 / 343, -1.0), above = std::nextafter(below, 1.0),
               beyond = std::nextafter(above, 1.0);
  EXPECT_TRUE(is_above(t, below));
  EXPECT_EQ(is_above(t, above), Rational(-143, 343) > Rational(above));
  EXPECT_FALSE(is_above(t, beyond));
  EXPECT_TRUE(is_above(-1.0 * t, 0.4));
  EXPECT_FALSE(is_above(-1.0 * t, 0.5));
}

TEST(LevelQuestion, TheLevelItselfAndZeroAreNotAbove) {
  EXPECT_FALSE(is_above({1, 0, -1, 0, 0, 0}, 0));
  EXPECT_FALSE(is_above({3, 3, 3, 0, 0, 0}, -0.5));
  EXPECT_TRUE(is_above({-0x1p-300, -0x1p-300, 0x1p-299, 0, 0, 0}, 0.999));
}

TEST(LevelQuestion, DifferencesOfDiagonalEntriesAreExact) {
  const double tiny = 0x1p-80;                        // lost in 1 - tiny
  EXPECT_FALSE(is_above({1, tiny, -1, 0, 0, 0}, 0));  // middle value above the mean: mode < 0
  EXPECT_TRUE(is_above({1, -tiny, -1, 0, 0, 0}, 0));
}

TEST(EdgeCrossings, TangencyCountsFromBelowOnly) {
  const PlanarWitness& tangent = planar_witness("tangent_edge");
  const auto corners = corners_of(tangent.corners());
  EXPECT_EQ(exact_edge_crossings(LevelQuestion(corners, 0.79), 0, 1), 2);
  EXPECT_EQ(exact_edge_crossings(LevelQuestion(corners, 0.8 - 1e-9), 0, 1), 2);
  EXPECT_EQ(exact_edge_crossings(LevelQuestion(corners, 0.8 + 1e-9), 0, 1), 0);
}

TEST(EdgeCrossings, AgreeWithDenseSampling) {
  Random random(11);
  for (int trial = 0; trial < 400; ++trial) {
    const auto corners = corners_of(random.tet_tensors());
    const LevelQuestion question(corners, 1.98 * (random.uniform() - 0.5));
    int sampled = 0;
    bool last = false;
    constexpr int n = 4000;
    for (int step = 0; step <= n; ++step) {
      const bool next = question.is_above(std::array<std::int64_t, 4>{n - step, step, 0, 0});
      sampled += step > 0 && next != last;
      last = next;
    }
    EXPECT_EQ(exact_edge_crossings(question, 0, 1), sampled) << "trial " << trial;
  }
}

TEST(BruteForce, ReproducesEveryFieldWitness) {
  // Some of these levels lie a thousandth from a saddle on purpose, in large tetrahedra.
  const BruteForceOptions close_to_critical{.band = 0.02, .confirm_handles = false};
  for (const FieldWitness& witness : field_witnesses()) {
    for (const TetCase& tet : witness.cases) {
      BruteForceTrace trace;
      const auto found = brute_force_topology(corners_of(witness.field.at(tet.points)),
                                              tet.mode.value(), close_to_critical, &trace);
      ASSERT_TRUE(found) << witness.name << " at " << tet.mode.value() << ": " << trace.refused;
      EXPECT_EQ(found->components, tet.components) << witness.name << " at " << tet.mode.value();
      EXPECT_EQ(found->crossings(), tet.edge_crossings)
          << witness.name << " at " << tet.mode.value();
    }
  }
}

TEST(BruteForce, ReproducesEveryPlanarWitness) {
  for (const PlanarWitness& witness : planar_witnesses()) {
    const auto corners = corners_of(witness.corners());
    for (const CurveCase& curve : witness.curves) {
      const double mode = curve.mode.value();
      const auto found = brute_force_face_topology(corners, mode);
      EXPECT_EQ(found.has_value(), !curve.tangent) << witness.name << " at " << mode;
      const FaceTopology seen = found ? *found : lattice_face_view(corners, mode, 256).topology;
      EXPECT_EQ(seen.closed_loops, curve.closed_loops) << witness.name << " at " << mode;
      EXPECT_EQ(seen.open_arcs, curve.open_arcs) << witness.name << " at " << mode;
    }
  }
}

TEST(BruteForce, RefusesWhatIsNotASurface) {
  const double critical = -143.0 / 343;
  const auto& saddle = field_witness("saddle_origin_rational");
  EXPECT_FALSE(brute_force_topology(corners_of(saddle.field.at(saddle.cases[0].points)), critical));
  for (const char* name : {"zero_vertex", "cone_apex_inside"}) {
    EXPECT_FALSE(brute_force_topology(corners_of(stratum_witness(name).tensors), 0.5)) << name;
  }
  for (const char* name : {"zero", "antiplane_shear", "one_direction"}) {
    EXPECT_FALSE(brute_force_topology(corners_of(stratum_witness(name).tensors), 0)) << name;
  }
}

TEST(BruteForce, ThinTubesNeedTheFineRungs) {
  Compared compared("thin tubes");
  const auto& witness = field_witness("offdiag3d");
  for (const TetCase& tet : witness.cases) {
    if (!tet.thin) continue;
    BruteForceTrace trace;
    brute_force_topology(corners_of(witness.field.at(tet.points)), tet.mode.value(), {}, &trace);
    ++compared;
    EXPECT_GT(trace.rungs, 1);
  }
}

TEST(BruteForce, ExactCountsCatchCrossingsThatTheLatticeMisses) {
  // One edge grazes the level between two lattice points; far from it nothing happens.
  const PlanarWitness& tangent = planar_witness("tangent_edge");
  const auto face = tangent.corners();
  const TetCorners corners = corners_of(TetTensors{face[0], face[1], face[2], tangent.at(1, 0)});
  const double mode = 0.8 - 1e-7;
  const LevelQuestion question(corners, mode);
  EXPECT_EQ(exact_edge_crossings(question, 0, 1), 2);
  EXPECT_EQ(lattice_view(corners, mode, 64).topology.edge_crossings[0], 0);
  BruteForceTrace trace;
  const auto found = brute_force_topology(corners, mode, {}, &trace);
  EXPECT_TRUE(!found || trace.rungs > 1);
}

TEST(BruteForce, DoesNotDependOnTheOrderOfTheVertices) {
  Compared compared("tetrahedra", 15);
  Random random(5);
  for (int trial = 0; trial < 30; ++trial) {
    const double mode = trial % 2 ? 0.4 : -0.85;
    auto corners = corners_of(random.tet_tensors());
    const auto first = brute_force_topology(corners, mode);
    std::rotate(corners.begin(), corners.begin() + 1 + trial % 3, corners.end());
    std::swap(corners[0], corners[1]);
    const auto second = brute_force_topology(corners, mode);
    if (first && second) {
      ++compared;
      EXPECT_EQ(first->components, second->components) << "trial " << trial;
    }
  }
}

TEST(BruteForce, NegatingTensorsAndModeChangesNothing) {
  Random random(6);
  for (int trial = 0; trial < 30; ++trial) {
    const double mode = trial % 2 ? 0.3 : 0.9;
    TetTensors tensors = random.tet_tensors();
    const auto first = brute_force_topology(corners_of(tensors), mode);
    for (auto& t : tensors) t = -1.0 * t;
    EXPECT_EQ(first, brute_force_topology(corners_of(tensors), -mode)) << "trial " << trial;
  }
}

TEST(BruteForce, DeviatorsAndTensorsAreTheSame) {
  Random random(7);
  const TetTensors tensors = random.tet_tensors();
  std::array<Deviator<double>, 4> deviators;
  for (std::size_t i = 0; i < 4; ++i) deviators[i] = deviator(tensors[i]);
  EXPECT_EQ(brute_force_topology(corners_of(tensors), 0.5),
            brute_force_topology(corners_of(deviators), 0.5));
}

TEST(BruteForce, AcceptedAnswersStandUpToAFinerLattice) {
  Random random(8);
  int accepted = 0;
  for (int trial = 0; trial < trials(25); ++trial) {
    const auto corners = corners_of(random.tet_tensors());
    for (const double mode : {0.1, -0.9}) {
      const auto found = brute_force_topology(corners, mode);
      if (!found) continue;
      ++accepted;
      EXPECT_EQ(found->components, lattice_view(corners, mode, 320).topology.components)
          << "trial " << trial << " mode " << mode;
    }
  }
  EXPECT_GE(accepted, trials(41));
}

// Loops and arcs on the faces are the boundary of the surface: arcs chain up to loops through the
// edges, so that the faces alone give the number of boundary loops that touch no edge.
TEST(BruteForce, FacesAndTetrahedronTellOneStory) {
  Compared compared("tetrahedra", 10);
  Random random(9);
  for (int trial = 0; trial < 25; ++trial) {
    const auto corners = corners_of(random.tet_tensors());
    const double mode = trial % 2 ? 0.6 : -0.93;
    const auto whole = brute_force_topology(corners, mode);
    if (!whole) continue;
    int closed = 0, arcs = 0, loops = 0;
    bool resolved = true;
    for (std::size_t omitted = 0; omitted < 4; ++omitted) {
      const TriangleCorners face{corners[(omitted + 1) % 4], corners[(omitted + 2) % 4],
                                 corners[(omitted + 3) % 4]};
      const auto curves = brute_force_face_topology(face, mode);
      resolved = resolved && curves;
      if (curves) closed += curves->closed_loops, arcs += curves->open_arcs;
    }
    if (!resolved) continue;
    for (const auto& component : whole->components) loops += component.loops;
    ++compared;
    EXPECT_EQ(arcs, whole->crossings()) << "trial " << trial;
    EXPECT_GE(loops, closed) << "trial " << trial;
    EXPECT_EQ(loops > closed, arcs > 0) << "trial " << trial;
  }
}

// No piece of a mode surface of one linear field is closed, whatever the rank.
RC_GTEST_PROP(BruteForceProperty, EveryComponentReachesTheBoundary, ()) {
  const TetSample sample = *small_integer_tet();
  const double mode = *mode_value(0.95);
  const auto found = brute_force_topology(corners_of(sample.tensors), mode, {.ladder = {{48, 64}}});
  if (!found) return;
  for (const auto& component : found->components) RC_ASSERT(component.loops > 0);
}

}  // namespace
}  // namespace tensortopo::test
