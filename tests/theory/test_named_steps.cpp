// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "proof_steps/machine_checked.hpp"
#include "proof_steps/steps.hpp"
#include "tensortopo/theory/statement.hpp"

namespace tensortopo::theory::test {
namespace {

TEST(NamedSteps, AreStepsOfTheProofs) {
  const std::vector<std::string> all = proofs::step_ids();
  const std::set<std::string> known(all.begin(), all.end());
  std::size_t named = 0;
  for (const Statement& statement : statements()) {
    for (const std::string& id : statement.steps) {
      EXPECT_EQ(known.count(id), 1u) << statement.id << ": " << id;
      ++named;
    }
  }
  EXPECT_GE(named, 80u);
}

TEST(NamedSteps, AndStatementsAreWhatTheoremsAreAbout) {
  const std::vector<std::string> all = proofs::step_ids();
  const std::set<std::string> steps(all.begin(), all.end());
  for (const proofs::MachineChecked& t : proofs::machine_checked()) {
    // What only the extractor and the checker rest on.
    const bool is_extraction = t.statement == "monotone-simplex" || t.statement == "checker-kernel";
    EXPECT_TRUE(find_statement(t.statement) != nullptr || steps.count(t.statement) == 1 ||
                is_extraction)
        << t.statement;
  }
}

}  // namespace
}  // namespace tensortopo::theory::test
