// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tensortopo {

/// Which steps of the paper's proofs to check.
struct ProofsCommand {
  std::vector<std::string> steps;  ///< ids; none: all steps
};

/// What came of it, in both forms.
struct ProofsReport {
  std::string text;  ///< a table for people; ends with a newline
  std::string json;  ///< one JSON object; ends without newline
  /// Nothing is refuted and nothing undecided.
  bool all_established = false;
};

/// Proves the steps. Throws UsageError for an id that no step has (and names those that there are),
/// and always in a program that was built without proofs-check.
ProofsReport run_proofs(const ProofsCommand& command);

}  // namespace tensortopo
