// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "tensortopo/analysis/progress.hpp"

namespace tensortopo {

struct CheckOutcome {
  std::string text, json;
  bool all_certified = false;
  std::size_t certified = 0, refuted = 0, undecided = 0;  ///< claims
};

/// Checks a certificate. Throws IoError for files that cannot be read as what they should be,
/// UsageError if the program was built without the checker.
CheckOutcome run_check(const std::string& input, const std::string& surface,
                       const std::string& certificate, const Progress& progress = {});

}  // namespace tensortopo
