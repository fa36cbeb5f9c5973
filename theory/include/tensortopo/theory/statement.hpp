// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/theory/check.hpp"

namespace tensortopo::theory {

/// A statement of the paper, or one of ours that the code relies on.
struct Statement {
  std::string id{};          ///< what `--theorem` asks for
  std::string paper{};       ///< theorem, equation or section; "none" for one of ours
  std::string claim{};       ///< what the paper says, in our words
  std::string hypotheses{};  ///< what a trial must satisfy
  std::string corrected{};   ///< what is true instead; empty if the claim is
  std::string sharper{};     ///< what is true beyond it; may be empty
  std::string strata{};      ///< the fields at which the claim fails; may be empty
  /// Tries `corrected`, or the claim if there is nothing to correct.
  Check check{};
  /// Tries the paper's own wording at a fixed witness, where it must be violated. Empty if there is
  /// nothing to correct.
  std::function<Outcome()> paper_at_witness{};
  /// More fields than this are not tried: a check may take long. 0 stands for any number.
  std::size_t most_fields = 0;
};

/// Every statement, in the order of the paper.
const std::vector<Statement>& statements();

/// The statement with this id, or nullptr.
const Statement* find_statement(std::string_view id);

}  // namespace tensortopo::theory
