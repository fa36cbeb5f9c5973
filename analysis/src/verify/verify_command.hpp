// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tensortopo/theory/statement.hpp"

namespace tensortopo {

/// Which statements to try, and on what.
struct VerifyCommand {
  std::vector<std::string> theorems;  ///< ids; none: all statements
  std::size_t fields = 100;           ///< at least 1
  std::uint64_t seed = 1;
  std::string scalar = "rational";  ///< the only one on offer
};

struct VerifyReport {
  std::vector<theory::Verification> statements;  ///< in the order of the paper
  /// Nothing is refuted and nothing undecided.
  bool all_established() const;
};

/// Tries the statements on the fields of the seed, exactly. Throws UsageError for an id that no
/// statement has (and names those that there are) and for another scalar.
VerifyReport run_verify(const VerifyCommand& command);

/// One JSON object. Ends without newline.
std::string to_json(const VerifyReport& report);
/// A table for people. Ends with a newline.
std::string to_text(const VerifyReport& report);

}  // namespace tensortopo
