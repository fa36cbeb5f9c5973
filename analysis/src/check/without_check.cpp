// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// In the place of check_command.cpp if proofs-check is not built.
#include "check/check_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {

CheckOutcome run_check(const std::string&, const std::string&, const std::string&,
                       const CheckDemands&, const Progress&) {
  throw UsageError("check: this program was built without it (TENSORTOPO_BUILD_PROOFS=OFF)");
}

}  // namespace tensortopo
