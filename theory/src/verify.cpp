// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/theory/statement.hpp"

#include <algorithm>
#include <chrono>

namespace tensortopo::theory {
namespace {

// Everything but the time.
Verification tried(const Statement& statement, std::uint64_t seed, std::size_t fields) {
  Verification result;
  result.id = statement.id;
  bool undecided = false;
  for (std::size_t i = 0; i < fields; ++i) {
    const Trial trial = random_trial(seed, i);
    const Outcome outcome = statement.check(trial);
    if (outcome.kind == Outcome::Kind::not_applicable) {
      ++result.not_applicable;
      continue;
    }
    ++result.tried;
    if (outcome.kind == Outcome::Kind::violated) {
      result.verdict = StatementVerdict::refuted;
      result.witness = outcome.detail + "; field " + std::to_string(i) + " of seed " +
                       std::to_string(seed) + ": " + text(trial.field);
      return result;
    }
    if (outcome.kind == Outcome::Kind::undecided && !undecided) {
      undecided = true;
      result.witness = outcome.detail;
    }
  }
  if (undecided) return result;
  if (result.tried == 0) {
    result.witness = "no field tried satisfies the hypotheses: " + statement.hypotheses;
    return result;
  }
  if (!statement.paper_at_witness) {
    result.verdict = StatementVerdict::holds;
    return result;
  }
  const Outcome at_witness = statement.paper_at_witness();
  if (at_witness.kind == Outcome::Kind::violated) {
    result.verdict = StatementVerdict::corrected;
    result.witness = at_witness.detail;
  } else {
    result.witness = "the witness does not refute the paper's wording";
  }
  return result;
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

const Statement* find_statement(std::string_view id) {
  const auto& all = statements();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Statement& s) { return s.id == id; });
  return found == all.end() ? nullptr : &*found;
}

Verification verify(const Statement& statement, std::uint64_t seed, std::size_t fields) {
  const auto start = std::chrono::steady_clock::now();
  Verification result = tried(statement, seed, fields);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace tensortopo::theory
