// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tensortopo/analysis/progress.hpp"

namespace tensortopo {

/// What must be certified.
struct CheckDemands {
  std::vector<std::string> modes;  ///< fractions or decimals
  std::string tensor;              ///< empty: any
  bool complete = false;           ///< no tetrahedron left out, no cell of the input skipped
};

struct CheckOutcome {
  std::string text, json;
  bool all_certified = false;  ///< and all demands are met
  std::size_t certified = 0, refuted = 0, undecided = 0;  ///< claims
};

/// Checks a certificate. Throws IoError for files that cannot be read as what they should be,
/// UsageError if the program was built without the checker, or for a mode that is no number.
CheckOutcome run_check(const std::string& input, const std::string& surface,
                       const std::string& certificate, const CheckDemands& demands = {},
                       const Progress& progress = {});

}  // namespace tensortopo
