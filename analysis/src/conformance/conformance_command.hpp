// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "conformance/score.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// A surface that somebody's program made of a field, to be compared with the certified one.
struct ConformanceCommand {
  std::filesystem::path surface;  ///< .vtp, .ply, .stl, .obj or .off
  std::filesystem::path input;    ///< the mesh
  std::filesystem::path truth;    ///< of `generate`; may be empty
  ModeValue mode;
  ReadOptions read;
  double merge = 0;       ///< merge points within boxes of this size; 0: equal ones
  double resolution = 8;  ///< of the certified surface
};

struct ConformanceReport {
  std::filesystem::path surface, input;
  std::vector<std::string> notes;  ///< of reading the mesh
  ModeValue mode;
  SurfaceScore score;
};

/// Extracts and certifies the mode surface, and scores the other one against it. A truth file must
/// be of the same field (by hash) and say the same as the certification of this run, else it throws
/// IoError: so the verdict rests on both.
/// Throws UsageError, IoError.
ConformanceReport run_conformance(const ConformanceCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const ConformanceReport& report);
/// Text for people. Ends with a newline.
std::string to_text(const ConformanceReport& report);

}  // namespace tensortopo
