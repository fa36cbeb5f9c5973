// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "proof_steps/machine_checked.hpp"
#include "proof_steps/steps.hpp"

namespace proofs {

/// A table for people. Ends with a newline, as the two below do.
std::string to_text(const std::vector<StepResult>& results);
/// One line a theorem, and how many there are.
std::string to_text(const std::vector<MachineChecked>& theorems);
/// One line a step, and one for each change that was overlooked.
std::string to_text(const std::vector<MutationResult>& results);
/// Sections named after the theorems; without times, so that two runs give the same.
std::string to_markdown(const std::vector<StepResult>& results);
/// One object {"steps": [..], "theorems": [..]}; an empty text becomes null. Ends without newline.
std::string to_json(const std::vector<StepResult>& results,
                    const std::vector<MachineChecked>& theorems = {});

}  // namespace proofs
