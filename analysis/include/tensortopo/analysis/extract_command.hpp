// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "tensortopo/analysis/extract_report.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// From a field in a file to the mode surfaces in another.
struct ExtractCommand {
  std::filesystem::path input;
  std::filesystem::path output;  ///< .vtp, .ply, .obj, .off or .stl
  std::vector<ModeValue> modes;  ///< surfaces in this order; repetitions count once
  bool generalized = false;      ///< after each mode its opposite
  bool strict = false;           ///< write nothing if a tetrahedron stays unresolved
  ReadOptions read;
  Sampling sampling;
};

/// The modes to extract, in order, each once.
///
/// Throws UsageError for none, and for +-1: degenerate curves are not surfaces.
std::vector<ModeValue> modes_to_extract(std::span<const ModeValue> modes, bool generalized);

/// Throws UsageError unless the extension names a format for surfaces.
void require_surface_extension(const std::filesystem::path& output);

/// Reads, extracts each mode's surface, and writes all of them to one file.
///
/// Laws      (1) the file depends on the input's bytes and the command only, not on the number of
///           threads; (2) on failure no file is left, and one that was there is untouched.
/// Throws    UsageError, IoError.
ExtractReport run_extract(const ExtractCommand& command, const Progress& progress = {});

}  // namespace tensortopo
