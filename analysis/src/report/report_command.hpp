// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/sweep/sweep.hpp"

namespace tensortopo {

/// From a field to one page for people: surfaces in 3D, curves, topology, what is left out, and the
/// checker's verdict.
struct ReportCommand {
  std::filesystem::path input;
  std::filesystem::path output;  ///< .html
  ReadOptions read;
  std::vector<ModeValue> modes;  ///< of surfaces; ascending in the page
  bool generalized = false;      ///< with each mode its opposite
  bool curves = true;            ///< degenerate curves of both kinds
  bool certify = true;           ///< and have it checked
  double resolution = 4;
  std::string uncertainty;  ///< of the field, as in `ExtractCommand`; empty for none
  std::optional<SweepOptions> sweep;
};

/// What `run_report` did.
struct ReportSummary {
  std::filesystem::path output;
  std::uintmax_t bytes = 0;
  std::size_t surfaces = 0, triangles = 0, unresolved = 0;
  std::string verdict;  ///< "certified", "refuted", "undecided" or "none"
  std::size_t certified = 0, claims = 0;
  /// Of an uncertain field: components that all fields within the radii have, and all there are.
  std::optional<std::size_t> stable_components, components;
};

/// Laws      (1) the page depends on the input's bytes and the command only; (2) it holds all that it
///           shows: a content security policy forbids it to load anything; (3) it appears whole or
///           not at all.
/// Throws    UsageError, IoError.
ReportSummary run_report(const ReportCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const ReportSummary& summary);
/// A line for people.
std::string to_text(const ReportSummary& summary);

}  // namespace tensortopo
