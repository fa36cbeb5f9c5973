// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "stability.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {

std::optional<Uncertainty> requested_uncertainty(const ExtractCommand& command,
                                                 std::span<const ModeValue> modes) {
  if (command.uncertainty.empty()) return std::nullopt;
  if (command.other)
    throw UsageError(
        "--uncertainty: only surfaces of the methods `manifold` and `graph` come with "
        "proofs");
  if (std::any_of(modes.begin(), modes.end(), is_degenerate))
    throw UsageError(
        "--uncertainty: of mode surfaces only, not of degenerate curves (--mode 1 or "
        "-1)");
  try {
    return parse_uncertainty(command.uncertainty);
  } catch (const std::invalid_argument& problem) {
    throw UsageError(std::string("--uncertainty: ") + problem.what());
  }
}

StabilityReport report_stability(StabilityRun& run, const std::string& radius,
                                 const ModeValue& mode, const ExtractOptions& options,
                                 const Extraction& extraction) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  StabilityReport report;
  report.summary = run.add(mode, options, extraction);
  report.radius = radius;
  report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return report;
}

}  // namespace tensortopo
