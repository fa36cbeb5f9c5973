// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "certificates/checks.hpp"
#include "proof_steps/steps.hpp"

namespace proofs {

/// To what a step belongs, in the order of the report.
enum class Place {
  background,
  theorem1,
  theorem2,
  corollary3,
  lemma4,
  theorem5,
  loops,
  theorem6,
  quads,
  faces,
  saddle,
  screen,
  stability,
  forms,
};

const char* name(Place place);

struct Step {
  Place place{};
  std::string id;
  Kind kind{};
  std::string claim;
  std::function<void(Checks&)> proof;  ///< of the corrected form if there is one
  std::string corrected;               ///< empty unless the claim is false
  std::string witness;
  std::function<void(Checks&)> refutation;  ///< of the claim, by the witness
};

/// Differences of the two sides of identities, in normal form modulo the relations of the claim.
using Differences = std::vector<Polynomial> (*)(Constants&);

inline Step identity(Place place, std::string id, std::string claim, Differences differences) {
  return {place,
          std::move(id),
          Kind::identity,
          std::move(claim),
          [differences](Checks& checks) { checks.all_vanish(differences(checks.k)); },
          {},
          {},
          {}};
}

using Assertions = void (*)(Checks&);

inline Step claim(Place place, std::string id, Kind kind, std::string text, Assertions proof) {
  return {place, std::move(id), kind, std::move(text), proof, {}, {}, {}};
}

/// What is printed, what is true, and against what is printed the witness.
struct Correction {
  std::string printed, corrected, witness;
};

inline Step correction(Place place, std::string id, Kind kind, Correction text, Assertions proof,
                       Assertions refutation) {
  return {place,
          std::move(id),
          kind,
          std::move(text.printed),
          proof,
          std::move(text.corrected),
          std::move(text.witness),
          refutation};
}

std::vector<Step> alpha_steps();
std::vector<Step> asymmetric_tensor_steps();
std::vector<Step> background_steps();
std::vector<Step> bifurcation_steps();
std::vector<Step> boundary_steps();
std::vector<Step> chart_steps();
std::vector<Step> critical_point_steps();
std::vector<Step> extrema_steps();
std::vector<Step> form_steps();
std::vector<Step> frame_steps();
std::vector<Step> gluing_steps();
std::vector<Step> lode_angle_steps();
std::vector<Step> loop_steps();
std::vector<Step> medium_eigenvector_steps();
std::vector<Step> mode_parameter_steps();
std::vector<Step> polarization_steps();
std::vector<Step> saddle_steps();
std::vector<Step> sphero_conal_steps();
std::vector<Step> stability_steps();

}  // namespace proofs
