// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace proofs {

/// A theorem that Coq has checked, as coq/README.md lists it: `ctest -L coq` compiles the theorems
/// again and fails if that page is not what they say.
struct MachineChecked {
  std::string statement;  ///< its id in theory, or that of a step
  std::string file, theorem, wording;
  std::string axioms;  ///< what it rests on beyond Coq's logic
};

/// In the order of the page; none if this was built without it.
const std::vector<MachineChecked>& machine_checked();

}  // namespace proofs
