// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "proofs/proofs_command.hpp"

#include <algorithm>

#include "proof_steps/report.hpp"
#include "proof_steps/steps.hpp"
#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {
namespace {

void refuse_unknown(const std::vector<std::string>& wanted) {
  const std::vector<std::string> ids = proofs::step_ids();
  for (const std::string& id : wanted) {
    if (std::find(ids.begin(), ids.end(), id) != ids.end()) continue;
    std::string known;
    for (const std::string& other : ids) known += (known.empty() ? "" : ", ") + other;
    throw UsageError("proofs: no step is called '" + id + "'; there are " + known);
  }
}

}  // namespace

ProofsReport run_proofs(const ProofsCommand& command) {
  refuse_unknown(command.steps);
  const std::vector<proofs::StepResult> results = proofs::run_steps(command.steps);
  const bool established = std::all_of(
      results.begin(), results.end(),
      [](const proofs::StepResult& result) { return proofs::is_established(result.verdict); });
  // Of a few steps only what they are.
  if (!command.steps.empty()) {
    return {proofs::to_text(results), proofs::to_json(results), established};
  }
  const auto& theorems = proofs::machine_checked();
  return {proofs::to_text(theorems) + '\n' + proofs::to_text(results),
          proofs::to_json(results, theorems), established};
}

}  // namespace tensortopo
