// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/stability/stability_run.hpp"

namespace tensortopo {

/// What the command asks for; nothing if it says nothing of uncertainty. Throws UsageError if that
/// cannot be read, or if the method has no proofs that it could apply to.
std::optional<Uncertainty> requested_uncertainty(const ExtractCommand& command);

/// Reads the radii, if the command names an array of them. Throws IoError, also if one is negative.
void read_radii(const ExtractCommand& command, const ReadResult& read, Uncertainty& uncertainty);

/// The stability of the next level's surface, or of the next kind's degenerate curves, for its
/// report.
/// @param radius  as it was asked for
/// @param level   the mode, or the kind
template <class Level, class Extracted>
StabilityReport report_stability(StabilityRun& run, const std::string& radius, const Level& level,
                                 const ExtractOptions& options, const Extracted& extraction) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  StabilityReport report;
  report.summary = run.add(level, options, extraction);
  report.radius = radius;
  report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return report;
}

}  // namespace tensortopo
