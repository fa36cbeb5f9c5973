// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyze/analyzed_mesh.hpp"
#include "analyze/sweep/sweep_check.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/sweep/sweep.hpp"

namespace tensortopo {

/// Topology of the mode surfaces of a field, as the mode goes from one value to another.
struct SweepCommand {
  std::filesystem::path input;
  ReadOptions read;
  SweepOptions sweep;
  std::size_t check_modes = 0;    ///< see `check_sweep`; 0 for no check
  std::filesystem::path picture;  ///< .png; may be empty
};

struct SweepReport : AnalyzedMesh {
  SweepOptions options;
  Sweep sweep;
  std::optional<SweepCheck> check;  ///< if asked for
  std::filesystem::path picture;
  double seconds = 0;

  /// Of the critical points found, each change is known; all levels are resolved; the Euler
  /// characteristic is known everywhere; and no two results contradict each other.
  bool is_complete() const;
  /// Levels, the sweep's own or those of the check, are not what the changes between them say.
  bool is_contradicted() const;
};

/// Reads A:B:N, as in "-0.9:0.9:19". Throws UsageError.
void parse_sweep(std::string_view text, SweepOptions& options);

/// Throws UsageError, IoError.
SweepReport run_sweep(const SweepCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const SweepReport& report);
/// Tables for people. Ends with a newline.
std::string to_text(const SweepReport& report);

}  // namespace tensortopo
