// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "groups.hpp"
#include "tensortopo/theory/verify.hpp"

namespace tensortopo::theory {
namespace {

using Kind = Outcome::Kind;

TEST(PlanarStatements, HoldOrAreCorrected) {
  for (const Statement& statement : planar_statements()) {
    const Verification result = verify(statement, random_trials(23, 60));
    EXPECT_GE(result.tried, 50u) << statement.id;
    EXPECT_EQ(result.verdict,
              statement.corrected.empty() ? StatementVerdict::holds : StatementVerdict::corrected)
        << statement.id << ": " << result.witness;
  }
}

bool is_noticed(const Check& check, Mutation mutation) {
  for (std::size_t i = 0; i < 10; ++i) {
    const Outcome outcome = check(random_trial(5, i), Arithmetic::rational, mutation);
    if (outcome.kind == Kind::violated) return true;
  }
  return false;
}

TEST(PlanarStatements, AreRefutedIfTheirNumbersAreWrong) {
  for (const Statement& statement : planar_statements()) {
    const std::size_t constants = statement.check.constants(random_trial(5, 0));
    EXPECT_GE(constants, 1u) << statement.id;
    for (std::size_t i = 0; i < constants; ++i) {
      EXPECT_TRUE(is_noticed(statement.check, {i, 1})) << statement.id << ' ' << i;
      EXPECT_TRUE(is_noticed(statement.check, {i, -1})) << statement.id << ' ' << i;
    }
  }
}

TEST(PlanarStatements, NameTheHypothesisThatAPlaneLacks) {
  Trial trial = random_trial(5, 0);
  trial.field.vertex[2] = trial.field.vertex[0];
  for (const Statement& statement : planar_statements()) {
    if (statement.id == "complement-pencil" || statement.id == "planar-redundancy" ||
        statement.id == "planar-points-at-infinity") {
      continue;  // they make planes of their own, or need none
    }
    EXPECT_EQ(statement.check(trial), Outcome::not_applicable("dependent tensors")) << statement.id;
  }
}

}  // namespace
}  // namespace tensortopo::theory
