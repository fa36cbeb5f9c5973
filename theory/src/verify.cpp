// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/theory/verify.hpp"

#include <algorithm>
#include <chrono>
#include <set>

namespace tensortopo::theory {
namespace {

// Tries the fields in order; true if the statement has passed all that satisfy its hypotheses.
bool passes(const Statement& statement, const Trials& trials, Arithmetic arithmetic,
            Verification& result) {
  bool undecided = false;
  double widest = 0;
  std::set<std::string> configurations;
  const std::size_t most = statement.most_fields == 0 ? trials.count : statement.most_fields;
  for (std::size_t i = 0; i < trials.count && result.tried < most; ++i) {
    const Trial trial = trials.at(i);
    const Outcome outcome = statement.check(trial, arithmetic);
    if (outcome.kind == Outcome::Kind::not_applicable) {
      ++result.not_applicable[outcome.detail];
      continue;
    }
    ++result.tried;
    if (outcome.configuration.empty()) {
      std::string words;
      for (const Rational& q : invariants(trial.field)) words += q.str() + ' ';
      configurations.insert(std::move(words));
    } else {
      configurations.insert(outcome.configuration);
    }
    result.configurations = configurations.size();
    if (outcome.kind == Outcome::Kind::violated) {
      result.verdict = StatementVerdict::refuted;
      result.witness =
          outcome.detail + "; " + trials.name(i) + ": vertex tensors " + text(trial.field);
      return false;
    }
    if (outcome.kind == Outcome::Kind::undecided && (!undecided || outcome.reach > widest)) {
      undecided = true;
      widest = outcome.reach;
      result.witness = outcome.detail + "; " + trials.name(i);
    }
  }
  if (undecided) return false;
  if (result.tried == 0) {
    result.witness = "no field tried satisfies the hypotheses: " + statement.hypotheses;
  }
  return result.tried > 0;
}

void judge(const Statement& statement, const Trials& trials, Arithmetic arithmetic,
           Verification& result) {
  if (!statement.check.suffices(arithmetic)) {
    result.witness = "needs exact signs: " + std::string(name(Arithmetic::rational)) + " only";
    return;
  }
  if (!passes(statement, trials, arithmetic, result)) return;
  if (!statement.paper_at_witness) {
    result.verdict = StatementVerdict::holds;
    return;
  }
  const Outcome at_witness = statement.paper_at_witness();
  if (at_witness.kind == Outcome::Kind::violated) {
    result.verdict = StatementVerdict::corrected;
    result.witness = at_witness.detail;
  } else {
    result.witness = "the witness does not refute the paper's wording";
  }
}

}  // namespace

std::string_view name(StatementVerdict verdict) {
  switch (verdict) {
    case StatementVerdict::holds:
      return "holds";
    case StatementVerdict::corrected:
      return "corrected";
    case StatementVerdict::refuted:
      return "refuted";
    case StatementVerdict::undecided:
      break;
  }
  return "undecided";
}

Trials random_trials(std::uint64_t seed, std::size_t count) {
  return {count, [seed](std::size_t i) { return random_trial(seed, i); },
          [seed](std::size_t i) {
            return "field " + std::to_string(i) + " of seed " + std::to_string(seed);
          }};
}

Verification verify(const Statement& statement, const Trials& trials, Arithmetic arithmetic) {
  const auto start = std::chrono::steady_clock::now();
  Verification result;
  result.id = statement.id;
  judge(statement, trials, arithmetic, result);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace tensortopo::theory
