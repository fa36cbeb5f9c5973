// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "arbitrary_trial.hpp"
#include "support/trials.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "tensortopo/theory/verify.hpp"

namespace tensortopo::theory::test {
namespace {

using Kind = Outcome::Kind;

// Statements whose check is a computation of its own are not tried on everything that is drawn.
bool is_quick(const Statement& statement) { return statement.most_fields == 0; }

RC_GTEST_PROP(Statements, HoldOrAreCorrectedOverRationals, (const TrialParts& parts)) {
  const Trial trial = trial_of(parts);
  for (const Statement& statement : statements()) {
    if (!is_quick(statement)) continue;
    const Outcome outcome = statement.check(trial);
    RC_LOG() << statement.id << ": " << outcome.detail << '\n';
    RC_ASSERT(outcome.kind == Kind::holds || outcome.kind == Kind::not_applicable);
  }
}

RC_GTEST_PROP(Statements, AreNotRefutedByEnclosures, (const TrialParts& parts)) {
  const Trial trial = trial_of(parts);
  for (const Statement& statement : statements()) {
    for (const Arithmetic arithmetic : kArithmetics) {
      if (!is_quick(statement) || !statement.check.suffices(arithmetic)) continue;
      const Outcome outcome = statement.check(trial, arithmetic);
      RC_LOG() << statement.id << " over " << name(arithmetic) << ": " << outcome.detail << '\n';
      RC_ASSERT(outcome.kind != Kind::violated);
    }
  }
}

RC_GTEST_PROP(Statements, AreLeftOpenByLittleAtAHundredDigits, (const TrialParts& parts)) {
  const Trial trial = trial_of(parts);
  for (const Statement& statement : statements()) {
    if (!is_quick(statement) || !statement.check.suffices(Arithmetic::real100)) continue;
    const Outcome fine = statement.check(trial, Arithmetic::real100);
    const Outcome coarse = statement.check(trial, Arithmetic::real53);
    RC_LOG() << statement.id << ": " << fine.detail << " and " << coarse.detail << '\n';
    // What is open is rounding: it shrinks with the unit roundoff, by more than eighty digits.
    // (Bounds hold what may underflow in doubles, which says nothing here.)
    if (fine.reach > std::numeric_limits<double>::min()) {
      RC_ASSERT(fine.reach < coarse.reach * 1e-80);
    }
  }
}

// One test for each statement, so that a failure names it.
class EachStatement : public testing::TestWithParam<std::size_t> {
 protected:
  const Statement& statement() const { return statements()[GetParam()]; }
  /// Fields enough for every hypothesis to be met.
  static constexpr std::size_t kFields = 200;
  /// As many, or what is enough for a statement whose check takes long; of these fewer in the short
  /// suite.
  std::size_t fields() const {
    if (is_quick(statement())) return kFields;
    const std::size_t most = std::min(kFields, statement().most_fields);
    return tensortopo::test::full_or_short(most, most / 2);
  }
};

TEST_P(EachStatement, IsEstablishedOnManyFields) {
  const Verification result = verify(statement(), random_trials(7, fields()));
  EXPECT_EQ(result.verdict,
            statement().corrected.empty() ? StatementVerdict::holds : StatementVerdict::corrected)
      << result.witness;
  const std::size_t wanted = is_quick(statement()) ? kFields / 6 : fields() / 2;
  EXPECT_GE(result.tried, wanted);
  EXPECT_GE(result.configurations, std::min(kFewConfigurations, fields() / 2));
  EXPECT_LE(result.configurations, result.tried);
  if (!is_quick(statement())) return;
  std::size_t others = 0;
  for (const auto& [why, count] : result.not_applicable) others += count;
  EXPECT_EQ(result.tried + others, kFields);
}

// Each number of a claim is made wrong, by one more and by one less: at least one of the two must
// be seen, on the fields that the program tries. (A smaller lower bound is still a bound.)
TEST_P(EachStatement, IsRefutedIfANumberOfItIsWrong) {
  const std::size_t fields = is_quick(statement()) ? kFields : 80;
  std::size_t constants = 0;
  for (std::size_t i = 0; i < 20; ++i) {
    constants = std::max(constants, statement().check.constants(random_trial(7, i)));
  }
  ASSERT_GE(constants, 1u);
  // The first fields of seed 11 show more of what takes long.
  const std::uint64_t seed =
      is_quick(statement()) ? 7 : tensortopo::test::full_or_short<std::uint64_t>(7, 11);
  for (std::size_t c = 0; c < constants; ++c) {
    bool noticed = false;
    for (std::size_t i = 0; i < fields && !noticed; ++i) {
      for (const int change : {1, -1}) {
        const Outcome outcome =
            statement().check(random_trial(seed, i), Arithmetic::rational, {c, change});
        noticed = noticed || outcome.kind == Kind::violated;
      }
    }
    EXPECT_TRUE(noticed) << "number " << c;
  }
}

TEST_P(EachStatement, HasAWitnessAgainstThePaperIfItCorrectsIt) {
  EXPECT_EQ(statement().corrected.empty(), !statement().paper_at_witness);
  if (!statement().paper_at_witness) return;
  const Outcome outcome = statement().paper_at_witness();
  EXPECT_EQ(outcome.kind, Kind::violated);
  EXPECT_FALSE(outcome.detail.empty());
  EXPECT_EQ(statement().paper_at_witness(), outcome);
}

// The second kind of change: a hypothesis is dropped, and the field named must violate the rest.
TEST_P(EachStatement, NeedsTheHypothesesThatItSaysItNeeds) {
  for (const Needed& needed : statement().needed) {
    const Outcome outcome = needed.without();
    EXPECT_EQ(outcome.kind, Kind::violated) << needed.hypothesis;
    EXPECT_FALSE(outcome.detail.empty());
  }
}

TEST_P(EachStatement, SaysWhatItsHypothesesAreFor) {
  EXPECT_FALSE(statement().needed.empty() && statement().unneeded.empty());
}

TEST_P(EachStatement, SaysWhatIsWrongIfItCorrectsThePaper) {
  EXPECT_EQ(statement().corrected.empty(), statement().flaws.empty());
}

TEST_P(EachStatement, GivesTheSameResultAgain) {
  const auto once = [&] {
    const std::size_t slow = tensortopo::test::full_or_short<std::size_t>(4, 2);
    Verification result = verify(statement(), random_trials(3, is_quick(statement()) ? 20 : slow));
    return std::tuple(result.verdict, result.tried, result.not_applicable, result.witness);
  };
  EXPECT_EQ(once(), once());
}

std::string name_of(const testing::TestParamInfo<std::size_t>& info) {
  std::string words;
  bool start = true;
  for (const char c : statements()[info.param].id) {
    if (c == '-') {
      start = true;
      continue;
    }
    words += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    start = false;
  }
  return words;
}

INSTANTIATE_TEST_SUITE_P(Theory, EachStatement, testing::Range<std::size_t>(0, statements().size()),
                         name_of);

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

Verification verify_kind(const Outcome& outcome) {
  Statement statement = statements().front();
  statement.check = Check([outcome](const Trial&, Facts<Rational>& facts) {
    if (outcome.kind == Kind::undecided) facts.undecided(outcome.detail);
    if (outcome.kind == Kind::not_applicable) facts.not_applicable(outcome.detail);
    if (outcome.kind == Kind::violated) facts.holds(outcome.detail, false);
  });
  return verify(statement, random_trials(7, 30));
}

TEST(Statements, AreCalledByIdOrByThePapersNumber) {
  EXPECT_EQ(statements_called("mode-range").size(), 1u);
  for (const std::string number : {"1", "2", "3", "4", "5", "6"}) {
    EXPECT_FALSE(statements_called(number).empty()) << number;
  }
  EXPECT_GE(statements_called("5").size(), 3u);
  EXPECT_TRUE(statements_called("7").empty());
  EXPECT_TRUE(statements_called("").empty());
}

// A field that is rotated or scaled is no other configuration; one that is changed is.
TEST(Statements, CountFieldsUpToRotationAndScaling) {
  const Trial trial = random_trial(7, 0);
  Random random(3);
  const Basis basis = random_basis(random);
  TetrahedronField<Rational> turned, changed = trial.field;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto t = to_tensor(trial.field.vertex[i]);
    const auto entry = [&](std::size_t p, std::size_t q) {
      return Rational(Rational(7) * dot(basis[p], t * basis[q]));
    };
    turned.vertex[i] = deviator(SymmetricTensor<Rational>{entry(0, 0), entry(1, 1), entry(2, 2),
                                                          entry(0, 1), entry(1, 2), entry(0, 2)});
  }
  changed.vertex[0].xy = changed.vertex[0].xy + Rational(1);
  EXPECT_EQ(invariants(turned), invariants(trial.field));
  EXPECT_NE(invariants(changed), invariants(trial.field));
}

TEST(Statements, AreUndecidedWhereNothingCouldBeTried) {
  EXPECT_EQ(verify_kind(Outcome::undecided("why")).verdict, StatementVerdict::undecided);
  EXPECT_EQ(verify_kind(Outcome::undecided("why")).witness, "why; field 0 of seed 7");
  const Verification none = verify_kind(Outcome::not_applicable("no"));
  EXPECT_EQ(none.verdict, StatementVerdict::undecided);
  EXPECT_EQ(none.not_applicable.at("no"), 30u);
}

TEST(Statements, AreRefutedByTheFirstFieldThatViolatesThem) {
  const Verification result = verify_kind(Outcome::violated("what"));
  EXPECT_EQ(result.verdict, StatementVerdict::refuted);
  EXPECT_EQ(result.tried, 1u);
  EXPECT_EQ(result.witness.find("what; field 0 of seed 7: vertex tensors ["), 0u);
}

TEST(Statements, AreUndecidedIfTheWitnessDoesNotRefuteThePaper) {
  Statement statement = *find_statement("real-domain");
  statement.paper_at_witness = [] { return Outcome::holds(); };
  EXPECT_EQ(verify(statement, random_trials(1, 20)).verdict, StatementVerdict::undecided);
}

TEST(Statements, OfStrictSignsAreDecidedByEnclosuresToo) {
  const Statement& statement = *find_statement("real-domain");
  for (const Arithmetic arithmetic : kArithmetics) {
    EXPECT_EQ(verify(statement, random_trials(7, 50), arithmetic).verdict,
              StatementVerdict::corrected)
        << name(arithmetic);
  }
}

TEST(Statements, ThatNeedExactSignsSaySo) {
  const Verification result =
      verify(*find_statement("boundary-degree"), random_trials(7, 10), Arithmetic::interval);
  EXPECT_EQ(result.verdict, StatementVerdict::undecided);
  EXPECT_EQ(result.tried, 0u);
  EXPECT_NE(result.witness.find("rational"), std::string::npos);
}

}  // namespace
}  // namespace tensortopo::theory::test
