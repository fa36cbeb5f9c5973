// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The proofs of the paper's appendix cut into steps, each proved by exact arithmetic over the
/// rational numbers. Shares nothing with the library whose mathematics it checks.
namespace proofs {

enum class Kind {
  identity,    ///< polynomials that vanish, modulo relations that the claim names
  inequality,  ///< a sign, by squares, by signs of coefficients, or by counting roots
  count,       ///< a number of solutions, degrees, edges or cells
};

enum class Verdict {
  holds,      ///< proved as printed
  corrected,  ///< the printed form is refuted by the witness, the corrected form is proved
  refuted,    ///< what should have been proved is false
  undecided,  ///< a certificate does not apply
};

struct StepResult {
  std::string id;
  std::string theorem;    ///< the theorem to which the step belongs, or what it serves
  std::string claim;      ///< what is printed, or what is claimed here where nothing is
  std::string corrected;  ///< what is proved instead; empty if the claim holds
  Kind kind = Kind::identity;
  Verdict verdict = Verdict::undecided;
  std::string witness;  ///< against the claim, or why the step is not established; else empty
  double seconds = 0;
};

/// What became of a step as its constants were increased by one, and its hypotheses dropped, one
/// at a time.
struct MutationResult {
  std::string id;
  std::size_t changes = 0;
  std::vector<std::size_t> overlooked;  ///< constants whose change altered nothing
  std::size_t hypotheses = 0;           ///< relations and intervals that the step uses
  std::vector<std::string> unneeded;    ///< those without which it holds all the same
  bool established = false;             ///< unchanged, the step holds or holds as corrected
  double seconds = 0;
  /// Established, with constants, and every change and every loss was noticed.
  bool passed() const {
    return established && changes > 0 && overlooked.empty() && unneeded.empty();
  }
};

/// In the order of the paper.
std::vector<std::string> step_ids();

/// Proves the steps named, or all if none is, in the order of the paper. Ids that no step has are
/// ignored: ask step_ids().
std::vector<StepResult> run_steps(const std::vector<std::string>& ids = {});

/// The same steps, once for each constant of each.
std::vector<MutationResult> run_mutations(const std::vector<std::string>& ids = {});

inline bool is_established(Verdict verdict) {
  return verdict == Verdict::holds || verdict == Verdict::corrected;
}
const char* name(Kind kind);
const char* name(Verdict verdict);

}  // namespace proofs
