// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The statements about topology, and wrong versions of them.
#include <gtest/gtest.h>

#include "groups.hpp"
#include "support/trials.hpp"
#include "tensors.hpp"
#include "tensortopo/theory/verify.hpp"
#include "topology/checks.hpp"

namespace tensortopo::theory {
namespace {

TEST(TopologyStatements, AreEstablishedOnSomeFields) {
  const auto fields = tensortopo::test::full_or_short<std::size_t>(12, 4);
  for (const Statement& statement : topology_statements()) {
    const Verification result = verify(statement, random_trials(11, fields));
    EXPECT_EQ(result.verdict,
              statement.corrected.empty() ? StatementVerdict::holds : StatementVerdict::corrected)
        << statement.id << ": " << result.witness;
    EXPECT_GE(result.tried, fields / 4) << statement.id;
  }
}

TEST(TopologyStatements, HaveAWitnessIfTheyCorrectThePaper) {
  for (const Statement& statement : topology_statements()) {
    EXPECT_EQ(statement.corrected.empty(), !statement.paper_at_witness) << statement.id;
    if (!statement.paper_at_witness) continue;
    const Outcome outcome = statement.paper_at_witness();
    EXPECT_EQ(outcome.kind, Outcome::Kind::violated) << statement.id;
    EXPECT_FALSE(outcome.detail.empty()) << statement.id;
  }
}

// Whether one of a few fields shows that a claimed number is wrong.
bool is_noticed(const Check& check, std::size_t constant, int change) {
  for (std::size_t i = 0; i < 6; ++i) {
    const Outcome outcome =
        check(random_trial(11, i), Arithmetic::rational, Mutation{constant, change});
    if (outcome.kind == Outcome::Kind::violated) return true;
  }
  return false;
}

TEST(TopologyStatements, AreRefutedIfTheirNumbersAreWrong) {
  const Trial with_frame = random_trial(11, 4);
  for (const Statement& statement : topology_statements()) {
    const std::size_t constants = statement.check.constants(with_frame);
    EXPECT_GT(constants, 0u) << statement.id;
    for (std::size_t c = 0; c < constants; ++c) {
      EXPECT_TRUE(is_noticed(statement.check, c, 1)) << statement.id << ", number " << c;
      EXPECT_TRUE(is_noticed(statement.check, c, -1)) << statement.id << ", number " << c;
    }
  }
}

TEST(TopologyStatements, NeedExactSigns) {
  for (const Statement& statement : topology_statements()) {
    EXPECT_TRUE(statement.check.suffices(Arithmetic::rational)) << statement.id;
    EXPECT_FALSE(statement.check.suffices(Arithmetic::interval)) << statement.id;
  }
}

// Cut along the loop and the arcs, and filled along the loop, each piece is a sphere with holes.
void expect_spheres_with_holes(const LoopCut& cut) {
  EXPECT_EQ(cut.surface.euler + cut.arcs + 2, 2 * cut.pieces - cut.boundary_loops);
}

// Loops of the complex domain's boundary inside a tetrahedron: a handle in two of them; in the two
// others one sphere with three holes, where the tube around the loop joins a disc and an annulus.
TEST(InteriorLoop, HasAHandleOrJoinsTwoSheets) {
  for (const LoopTetrahedron& t : {loop_of_handle(), loop_of_wide_handle()}) {
    const LoopOutcome found = loop_outcome(t);
    EXPECT_TRUE(found.is_inside) << text(t);
    ASSERT_TRUE(found.cut) << text(t);
    EXPECT_EQ(found.cut->surface,
              (LevelSurface{.euler = -2, .components = 1, .boundary_loops = 2}));
    EXPECT_EQ(found.cut->sheets, 1);
    EXPECT_TRUE(found.cut->has_handle());
    EXPECT_EQ(found.cut->arcs, 1);
    expect_spheres_with_holes(*found.cut);
  }
  for (const LoopTetrahedron& t : {loop_of_tube(), loop_of_another_tube()}) {
    const LoopOutcome found = loop_outcome(t);
    EXPECT_TRUE(found.is_inside) << text(t);
    ASSERT_TRUE(found.cut) << text(t);
    EXPECT_EQ(found.cut->surface,
              (LevelSurface{.euler = -1, .components = 1, .boundary_loops = 3}));
    EXPECT_EQ(found.cut->sheets, 2);
    EXPECT_FALSE(found.cut->has_handle());
    EXPECT_EQ(found.cut->arcs, 1);
    expect_spheres_with_holes(*found.cut);
  }
}

TEST(NoClosedComponent, IsUndecidedAtACriticalMode) {
  // The check's own choice of a mode, made critical by a saddle of that mode in the tetrahedron.
  Trial trial;
  trial.random = Random(1);
  Random copy = trial.random;
  const int parameter = copy.integer(20, 900), sign = copy.integer(0, 1) == 0 ? 1 : -1;
  const Rational high(1009 + parameter), middle(1009 - parameter), low = -high - middle;
  Tensor saddle = {middle - low, low - high, high - middle, 0, 0, 0};
  if (determinant(saddle) * Rational(sign) < 0) saddle = Rational(-1) * saddle;
  const int size = 300;
  const std::array<Tensor, 4> corners = {
      Tensor{0, 0, 0, size, size, size}, Tensor{0, 0, 0, size, -size, -size},
      Tensor{0, 0, 0, -size, size, -size}, Tensor{0, 0, 0, -size, -size, size}};
  for (std::size_t i = 0; i < 4; ++i) trial.field.vertex[i] = deviator(saddle + corners[i]);
  Facts<Rational> facts;
  no_closed_component(trial, facts);
  EXPECT_EQ(facts.outcome(), Outcome::undecided(kBudgetExceeded));
}

TEST(NoClosedComponent, IsNotAboutFieldsThatVanish) {
  Trial trial;
  trial.field.vertex = {deviator(Tensor{1, 2, 3, 4, 5, 6}),
                        deviator(Tensor{3, 1, 4, 1, 5, 9}),
                        deviator(Tensor{2, 7, 1, 8, 2, 8}),
                        {}};
  Facts<Rational> facts;
  no_closed_component(trial, facts);
  EXPECT_EQ(facts.outcome().kind, Outcome::Kind::not_applicable);
  // Minus the sum of the others: it vanishes in the middle.
  const auto& v = trial.field.vertex;
  trial.field.vertex[3] = Rational(-1) * (v[0] + v[1] + v[2]);
  Facts<Rational> again;
  no_closed_component(trial, again);
  EXPECT_EQ(again.outcome().kind, Outcome::Kind::not_applicable);
  // Their sum: it vanishes elsewhere.
  trial.field.vertex[3] = v[0] + v[1] + v[2];
  Facts<Rational> elsewhere;
  no_closed_component(trial, elsewhere);
  EXPECT_EQ(elsewhere.outcome(), Outcome::holds());
}

}  // namespace
}  // namespace tensortopo::theory
