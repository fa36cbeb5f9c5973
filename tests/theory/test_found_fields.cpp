// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Fields that a search found as it tried to break the corrected statements: close to the
// exceptional fields at which the paper's wording fails. None of the statements fails at them.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "candidate.hpp"
#include "tensortopo/theory/statement.hpp"

namespace tensortopo::theory::test {
namespace {

struct FoundField {
  std::string id;
  Candidate candidate;
};

// Of tensortopo_theory_search.
const std::vector<FoundField>& found_fields() {
  static const std::vector<FoundField> all = {
#include "found_fields.inc"
  };
  return all;
}

TEST(FoundFields, DoNotBreakTheStatements) {
  std::map<std::string, int> count;
  for (const auto& [id, candidate] : found_fields()) {
    const Statement* statement = find_statement(id);
    ASSERT_NE(statement, nullptr) << id;
    const Outcome outcome = statement->check(trial_of(candidate));
    EXPECT_EQ(outcome.kind, Outcome::Kind::holds)
        << id << ' ' << text(candidate) << ": " << outcome.detail;
    ++count[id];
  }
  EXPECT_GE(found_fields().size(), 40u);
  for (const Statement& statement : statements()) {
    EXPECT_TRUE(statement.corrected.empty() || count[statement.id] > 0) << statement.id;
  }
}

TEST(FoundFields, AreDifferent) {
  std::set<std::string> seen;
  for (const auto& [id, candidate] : found_fields()) {
    EXPECT_TRUE(seen.insert(id + text(candidate)).second) << id << ' ' << text(candidate);
  }
}

TEST(Candidates, GiveTheSameTrialAgain) {
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    const Candidate c = changed(random_candidate(random), random);
    EXPECT_EQ(text(trial_of(c).field), text(trial_of(c).field));
    EXPECT_GE(distance_from_exceptional(c), 0);
    EXPECT_LE(distance_from_exceptional(c), 0.5);
  }
}

}  // namespace
}  // namespace tensortopo::theory::test
