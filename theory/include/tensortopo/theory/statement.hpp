// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/theory/check.hpp"

namespace tensortopo::theory {

/// What is wrong with the paper's wording. A statement may have more than one.
enum class Flaw : std::uint8_t {
  wording,      ///< a misprint, or words that say another thing than is meant and used
  projective,   ///< true with the points at infinity, stated in space
  exceptional,  ///< false for fields that the paper's structural stability excludes
  substantive,  ///< what is concluded or computed is wrong
};
inline constexpr std::array kFlaws = {Flaw::wording, Flaw::projective, Flaw::exceptional,
                                      Flaw::substantive};
/// For a table's row.
std::string_view name(Flaw flaw);

/// A hypothesis, and a field without it at which the statement fails.
struct Needed {
  std::string hypothesis;
  std::function<Outcome()> without;
};

/// A statement of the paper, or one of ours that the code relies on.
struct Statement {
  std::string id{};           ///< what `--theorem` asks for
  std::string paper{};        ///< theorem, equation or section; "none" for one of ours
  std::string claim{};        ///< what the paper says, in our words
  std::string hypotheses{};   ///< what a trial must satisfy
  std::string corrected{};    ///< what is true instead; empty if the claim is
  std::string sharper{};      ///< what is true beyond it; may be empty
  std::string special{};      ///< the fields at which the claim fails; may be empty
  std::vector<Flaw> flaws{};  ///< of the paper's wording; empty if there is nothing to correct
  /// Tries `corrected`, or the claim if there is nothing to correct.
  Check check{};
  /// Tries the paper's own wording at a fixed witness, where it must be violated. Empty if there is
  /// nothing to correct.
  std::function<Outcome()> paper_at_witness{};
  /// Hypotheses that are shown to be needed.
  std::vector<Needed> needed{};
  /// Hypotheses without a field at which the statement fails without them: what they are for.
  std::string unneeded{};
  /// Steps of proofs-check that prove it, or parts of it, by exact computation.
  std::vector<std::string> steps{};
  /// What no program has proved: inferences for a reader. Empty if there are none.
  std::string reader{};
  /// Where the check follows from how the trial is made or from a definition: what it restates.
  std::string restates{};
  /// More fields than this are not tried: a check may take long. 0 stands for any number.
  std::size_t most_fields = 0;
};

/// Every statement, in the order of the paper.
const std::vector<Statement>& statements();

/// The statement with this id, or nullptr.
const Statement* find_statement(std::string_view id);

/// The statement with this id; or all about one of the paper's results, called by its number:
/// theorems 1, 2, 5 and 6, corollary 3, lemma 4. Empty if there is none.
std::vector<const Statement*> statements_called(std::string_view name);

}  // namespace tensortopo::theory
