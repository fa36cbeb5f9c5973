// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tensortopo/theory/trial.hpp"

namespace tensortopo::theory {

/// What one trial says about a statement.
struct Outcome {
  enum class Kind {
    holds,
    violated,        ///< `detail` is a witness
    not_applicable,  ///< the trial lacks a hypothesis, named in `detail`
    undecided,       ///< `detail` is the reason
  };
  Kind kind = Kind::holds;
  std::string detail;

  static Outcome holds() { return {}; }
  static Outcome violated(std::string witness) { return {Kind::violated, std::move(witness)}; }
  static Outcome not_applicable(std::string why) { return {Kind::not_applicable, std::move(why)}; }
  static Outcome undecided(std::string why) { return {Kind::undecided, std::move(why)}; }
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Tries a statement on one field. Exact: no rounding, no tolerance.
using Check = std::function<Outcome(const Trial&)>;

/// What is known about a statement.
enum class StatementVerdict {
  holds,      ///< as the paper has it
  corrected,  ///< the paper's wording fails at a witness, ours has passed every trial
  refuted,    ///< a trial violates it
  undecided,  ///< no trial could decide, or a witness did not refute what it should
};

/// "holds", "corrected", "refuted", "undecided".
std::string_view name(StatementVerdict verdict);

/// A statement of the paper, or one of ours that the code relies on.
struct Statement {
  std::string id;          ///< what `--theorem` asks for
  std::string paper;       ///< theorem, equation or section; "none" for one of ours
  std::string claim;       ///< what the paper says, in our words
  std::string hypotheses;  ///< what a trial must satisfy
  std::string corrected;   ///< what is true instead; empty if the claim is
  /// Tries `corrected`, or the claim if there is nothing to correct.
  Check check;
  /// Tries the paper's own wording at a fixed witness, where it must be violated. Empty if there is
  /// nothing to correct.
  std::function<Outcome()> paper_at_witness;
};

/// Every statement, in the order of the paper.
const std::vector<Statement>& statements();

/// The statement with this id, or nullptr.
const Statement* find_statement(std::string_view id);

/// What trying a statement has given.
struct Verification {
  std::string id;
  StatementVerdict verdict = StatementVerdict::undecided;
  std::size_t tried = 0;           ///< fields that satisfied the hypotheses
  std::size_t not_applicable = 0;  ///< the others
  std::string witness;             ///< of a refutation, or the reason why nothing is decided
  double seconds = 0;
};

/// Tries a statement on the first `fields` fields of a seed, and re-checks its witness.
///
/// The first violation ends it. All but `seconds` depends on the arguments only.
Verification verify(const Statement& statement, std::uint64_t seed, std::size_t fields);

}  // namespace tensortopo::theory
