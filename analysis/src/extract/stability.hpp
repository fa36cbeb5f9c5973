// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/stability/stability_run.hpp"

namespace tensortopo {

/// What --uncertainty asks for; nothing if it is empty. Throws UsageError if it cannot be read.
std::optional<Uncertainty> requested_uncertainty(const std::string& text);

/// Reads the radii, if an array of them is named, of the file that `read` came from. Throws IoError,
/// also if one is negative.
void read_radii(const std::filesystem::path& input, const ReadOptions& options,
                const ReadResult& read, Uncertainty& uncertainty);

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
