// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/extract_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "extract/certificate.hpp"
#include "require_folder.hpp"
#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {
namespace {

/// Throws UsageError for surfaces that no proof is about, and for surfaces and curves in one file.
void require_proofs(const ExtractCommand& command, const std::vector<ModeValue>& modes) {
  if (command.other)
    throw UsageError(
        "--certify: only surfaces of the methods `bisection` and `manifold` come with proofs");
  if (std::any_of(modes.begin(), modes.end(), is_degenerate) &&
      !std::all_of(modes.begin(), modes.end(), is_degenerate))
    throw UsageError(
        "--certify: a certificate is of surfaces or of degenerate curves (--mode 1 or "
        "-1); extract them to files of their own");
}

/// Throws UsageError for options that do nothing for degenerate curves.
void require_no_surface_options(const ExtractCommand& command) {
  const char* const option = command.improve                              ? "--improve"
                             : command.all_samples                        ? "--all-samples"
                             : command.max_error > 0                      ? "--max-error"
                             : command.meshing == MeshingMethod::manifold ? "--method manifold"
                                                                          : nullptr;
  if (option != nullptr)
    throw UsageError(std::string(option) + ": has no effect on degenerate curves (--mode 1 or -1)");
}

/// Throws UsageError for what no estimate of the memory is about.
void require_estimate(const ExtractCommand& command, const std::vector<ModeValue>& modes) {
  const char* const option = command.other                  ? "--method"
                             : command.stream               ? "--stream"
                             : command.pieces > 1           ? "--pieces"
                             : command.max_error > 0        ? "--max-error"
                             : command.improve              ? "--improve"
                             : command.min_persistence > 0  ? "--min-persistence"
                             : !command.uncertainty.empty() ? "--uncertainty"
                                                            : nullptr;
  if (option != nullptr)
    throw UsageError(std::string("--memory: does not go with ") + option +
                     ", of which the memory is not known beforehand");
  if (std::any_of(modes.begin(), modes.end(), is_degenerate))
    throw UsageError(
        "--memory: does not go with degenerate curves (--mode 1 or -1), of which the memory is not "
        "known beforehand: give a number of --pieces");
}

}  // namespace

void require_sense(const ExtractCommand& command, const std::vector<ModeValue>& modes) {
  require_surface_extension(command.output, std::any_of(modes.begin(), modes.end(), is_degenerate));
  if (!(command.sampling.resolution > 0) || command.sampling.resolution > kLargestResolution) {
    throw UsageError(
        fmt::format("--resolution: must be a positive number, at most {}", kLargestResolution));
  }
  if (std::all_of(modes.begin(), modes.end(), is_degenerate)) require_no_surface_options(command);
  if (command.other && std::any_of(modes.begin(), modes.end(), is_degenerate)) {
    throw UsageError("--method: degenerate curves (--mode 1 or -1) have no other method");
  }
  if (command.only_neutral &&
      std::any_of(modes.begin(), modes.end(), [](const auto& mode) { return mode.sign() != 0; })) {
    throw UsageError("--method hybrid: extracts neutral surfaces (--mode 0) only");
  }
  if (command.other && command.max_error > 0) {
    throw UsageError(
        "--max-error: only surfaces of the methods `bisection` and `manifold` come with proofs");
  }
  if (command.max_error > 0 && std::any_of(modes.begin(), modes.end(), is_degenerate))
    throw UsageError("--max-error: is about surfaces, not degenerate curves (--mode 1 or -1)");
  if (command.improve && (command.other || command.max_error > 0)) {
    throw UsageError(
        "--improve: only for surfaces of the methods `bisection` and `manifold`, without "
        "--max-error");
  }
  if (!command.uncertainty.empty() && command.other)
    throw UsageError(
        "--uncertainty: only surfaces of the methods `bisection` and `manifold` come with proofs");
  if (command.memory > 0) require_estimate(command, modes);
  require_folder(command.output);
  if (!command.certificate.empty()) {
    require_certifiable(command.read, command.output, command.certificate);
    require_proofs(command, modes);
    require_folder(command.certificate);
  }
}

}  // namespace tensortopo
