// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "tensortopo/tensor/mode.hpp"
#include "tensortopo/theory/checks.hpp"
#include "tensortopo/theory/statement.hpp"

namespace tensortopo::theory {
namespace {

using Kind = Outcome::Kind;

RC_GTEST_PROP(Statements, HoldOrAreCorrectedOnFieldsOfAnySeed, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  for (const Statement& statement : statements()) {
    const Verification result = verify(statement, seed, 10);
    RC_LOG() << statement.id << ": " << result.witness << '\n';
    RC_ASSERT(result.verdict != StatementVerdict::refuted);
    if (result.tried > 0) RC_ASSERT(result.verdict != StatementVerdict::undecided);
  }
}

TEST(Statements, AreEstablishedOnManyFields) {
  for (const Statement& statement : statements()) {
    const Verification result = verify(statement, 7, 300);
    EXPECT_GE(result.tried, 50u) << statement.id;
    EXPECT_EQ(result.tried + result.not_applicable, 300u) << statement.id;
    EXPECT_EQ(result.verdict,
              statement.corrected.empty() ? StatementVerdict::holds : StatementVerdict::corrected)
        << statement.id << ": " << result.witness;
  }
}

TEST(Statements, HaveIdsOfTheirOwnAndWords) {
  std::set<std::string> ids;
  for (const Statement& statement : statements()) {
    EXPECT_TRUE(ids.insert(statement.id).second) << statement.id;
    EXPECT_EQ(find_statement(statement.id), &statement);
    EXPECT_FALSE(statement.paper.empty() || statement.claim.empty() ||
                 statement.hypotheses.empty());
  }
  EXPECT_EQ(find_statement("no-such-statement"), nullptr);
}

TEST(Statements, HaveAWitnessThatRefutesThePaperIfTheyCorrectIt) {
  for (const Statement& statement : statements()) {
    EXPECT_EQ(statement.corrected.empty(), !statement.paper_at_witness) << statement.id;
    if (!statement.paper_at_witness) continue;
    const Outcome outcome = statement.paper_at_witness();
    EXPECT_EQ(outcome.kind, Kind::violated) << statement.id;
    EXPECT_FALSE(outcome.detail.empty()) << statement.id;
    EXPECT_EQ(statement.paper_at_witness(), outcome) << statement.id;
  }
}

// A statement with a wrong number in it, tried as the right one is.
Verification verify_wrong(const Check& check) {
  Statement statement = statements().front();
  statement.check = check;
  return verify(statement, 7, 300);
}

Rational part(int p, int q) { return Rational(p) / Rational(q); }

TEST(Statements, AreRefutedIfTheirNumbersAreWrong) {
  const std::vector<std::pair<std::string, Check>> wrong = {
      {"larger range", check_mode_range(part(53, 1))},
      {"smaller range", check_mode_range(part(5401, 100))},
      {"discriminant", check_discriminant(part(53, 1))},
      {"mode parameter", check_mode_parameter(part(901, 100))},
      {"degree six", check_degree_six_equation(part(27, 1))},
      {"real domain, small", check_real_domain(part(1, 5))},
      {"real domain, large", check_real_domain(part(3, 10))},
      {"bifurcation", check_bifurcation(part(99, 100))},
  };
  for (const auto& [name, check] : wrong) {
    const Verification result = verify_wrong(check);
    EXPECT_EQ(result.verdict, StatementVerdict::refuted) << name;
    EXPECT_NE(result.witness.find("of seed 7"), std::string::npos) << name;
  }
}

TEST(Statements, AreViolatedAgainByTheFieldOfTheirWitness) {
  const Check wrong = check_discriminant(part(53, 1));
  const Trial trial = random_trial(7, 0);
  const Outcome first = wrong(trial);
  ASSERT_EQ(first.kind, Kind::violated);
  EXPECT_EQ(wrong(trial), first);
}

Verification verify_kind(const Outcome& outcome) {
  return verify_wrong([outcome](const Trial&) { return outcome; });
}

TEST(Statements, AreUndecidedWhereNothingCouldBeTried) {
  EXPECT_EQ(verify_kind(Outcome::undecided("why")).verdict, StatementVerdict::undecided);
  EXPECT_EQ(verify_kind(Outcome::undecided("why")).witness, "why");
  EXPECT_EQ(verify_kind(Outcome::not_applicable("no")).verdict, StatementVerdict::undecided);
}

TEST(Statements, AreUndecidedIfTheWitnessDoesNotRefuteThePaper) {
  Statement statement = *find_statement("real-domain");
  statement.paper_at_witness = [] { return Outcome::holds(); };
  EXPECT_EQ(verify(statement, 1, 20).verdict, StatementVerdict::undecided);
}

TEST(Statements, GiveTheSameResultAgain) {
  for (const Statement& statement : statements()) {
    Verification first = verify(statement, 3, 20), second = verify(statement, 3, 20);
    EXPECT_EQ(first.verdict, second.verdict);
    EXPECT_EQ(first.tried, second.tried);
    EXPECT_EQ(first.witness, second.witness);
  }
}

}  // namespace
}  // namespace tensortopo::theory
