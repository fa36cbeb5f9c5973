// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "tensortopo/theory/statement.hpp"

namespace tensortopo::theory {

/// What is known about a statement.
enum class StatementVerdict {
  holds,      ///< as the paper has it
  corrected,  ///< the paper's wording fails at a witness, ours has passed every trial
  refuted,    ///< a trial violates it
  undecided,  ///< no trial could decide, or a witness did not refute what it should
};

/// "holds", "corrected", "refuted", "undecided".
std::string_view name(StatementVerdict verdict);

/// With fewer configurations than this a statement is said to be tried in few.
inline constexpr std::size_t kFewConfigurations = 20;

/// What trying a statement has given.
struct Verification {
  std::string id;
  StatementVerdict verdict = StatementVerdict::undecided;
  std::size_t tried = 0;  ///< fields that satisfied the hypotheses
  /// Of these, those that differ by more than a rotation and a scaling: in what the check looks at.
  std::size_t configurations = 0;
  /// How often each hypothesis was lacking.
  std::map<std::string, std::size_t> not_applicable;
  std::string witness;  ///< of a refutation, or the reason why nothing is decided
  double seconds = 0;
};

/// The fields to try a statement on.
struct Trials {
  std::size_t count = 0;
  std::function<Trial(std::size_t)> at;
  std::function<std::string(std::size_t)> name;  ///< for witnesses
};

/// The first `count` random fields of a seed.
Trials random_trials(std::uint64_t seed, std::size_t count);

/// Tries a statement and re-checks its witness against the paper.
///
/// The first violation ends it. All but `seconds` depends on the arguments only.
Verification verify(const Statement& statement, const Trials& trials,
                    Arithmetic arithmetic = Arithmetic::rational);

}  // namespace tensortopo::theory
