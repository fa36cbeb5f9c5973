// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <set>
#include <stdexcept>

#include "algebra/hypotheses.hpp"
#include "certificates/step.hpp"

namespace proofs {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// By theorem, and within one in the order below.
std::vector<Step> all_steps() {
  std::vector<Step> all;
  for (const auto& part :
       {background_steps(), mode_parameter_steps(), frame_steps(), medium_eigenvector_steps(),
        asymmetric_tensor_steps(), boundary_steps(), alpha_steps(), chart_steps(),
        sphero_conal_steps(), bifurcation_steps(), extrema_steps(), critical_point_steps(),
        saddle_steps(), gluing_steps(), loop_steps(), lode_angle_steps(), stability_steps(),
        form_steps(), polarization_steps()})
    all.insert(all.end(), part.begin(), part.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const Step& s, const Step& t) { return s.place < t.place; });
  return all;
}

std::vector<Step> chosen_steps(const std::vector<std::string>& ids) {
  std::vector<Step> steps = all_steps();
  if (ids.empty()) return steps;
  std::erase_if(steps, [&](const Step& step) {
    return std::find(ids.begin(), ids.end(), step.id) == ids.end();
  });
  return steps;
}

struct Decision {
  Verdict verdict;
  std::string reason;
};

Decision decide(const Step& step, Constants& constants) try {
  Checks proof(constants), refutation(constants);
  step.proof(proof);
  if (proof.outcome() == Checks::Outcome::refuted) return {Verdict::refuted, proof.reason()};
  if (proof.outcome() == Checks::Outcome::undecided) return {Verdict::undecided, proof.reason()};
  if (!step.refutation) return {Verdict::holds, {}};
  step.refutation(refutation);
  if (refutation.outcome() == Checks::Outcome::proved) return {Verdict::corrected, step.witness};
  return {Verdict::undecided, "the witness does not refute the claim: " + refutation.reason()};
} catch (const std::domain_error& error) {
  return {Verdict::undecided, error.what()};
}

StepResult run(const Step& step) {
  const auto start = Clock::now();
  Constants constants;
  const Decision decision = decide(step, constants);
  return {step.id,   name(step.place), step.claim,      step.corrected,
          step.kind, decision.verdict, decision.reason, seconds_since(start)};
}

MutationResult mutate(const Step& step) {
  const auto start = Clock::now();
  Constants unchanged;
  MutationResult result;
  result.id = step.id;
  std::set<std::string> used;
  Verdict expected = Verdict::undecided;
  {
    const Hypotheses all;
    expected = decide(step, unchanged).verdict;
    used = all.used();
  }
  result.changes = unchanged.count();
  result.established = is_established(expected);
  result.hypotheses = used.size();
  for (const std::string& name : used) {
    const Hypotheses others(name);
    Constants constants;
    if (decide(step, constants).verdict == expected) result.unneeded.push_back(name);
  }
  for (std::size_t i = 0; i < unchanged.count(); ++i) {
    Constants constants(i);
    if (decide(step, constants).verdict == expected) result.overlooked.push_back(i);
  }
  result.seconds = seconds_since(start);
  return result;
}

}  // namespace

std::vector<std::string> step_ids() {
  std::vector<std::string> ids;
  for (const Step& step : all_steps()) ids.push_back(step.id);
  return ids;
}

std::vector<StepResult> run_steps(const std::vector<std::string>& ids) {
  std::vector<StepResult> results;
  for (const Step& step : chosen_steps(ids)) results.push_back(run(step));
  return results;
}

std::vector<MutationResult> run_mutations(const std::vector<std::string>& ids) {
  std::vector<MutationResult> results;
  for (const Step& step : chosen_steps(ids)) results.push_back(mutate(step));
  return results;
}

}  // namespace proofs
