// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "conformance/score.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/families/field_family.hpp"

namespace tensortopo {

/// Members of a family, or the field of a file, that belong to a suite.
struct SuiteEntry {
  std::string name;            ///< of the kind, or of the file without folder and extension
  std::filesystem::path file;  ///< empty for a family
  FieldKind kind = FieldKind::linear;
  std::uint64_t seed = 1;
  int count = 1;
  std::size_t tetrahedra = 0;    ///< of each; 0: the kind's default
  std::vector<ModeValue> modes;  ///< none: those of the member
  int subdivisions = 3;          ///< 0 to 3
};

/// The suite that a JSON file lists: {"suite": [{"kind", "seed", "count", "tetrahedra"?, "modes"?,
/// "subdivisions"?} or {"file", "modes", "subdivisions"?}, ...]}, files relative to the list's
/// folder. Throws IoError.
std::vector<SuiteEntry> read_suite(const std::filesystem::path& file);

/// What a method got wrong in one case, a mode of one member.
struct SuiteResult {
  std::string name;  ///< of the kind or file
  bool generated = true;
  int member = 0;
  ModeValue mode;
  std::string method;
  double cell = 0;  ///< longest edge of the mesh as it was before any subdivision
  SurfaceScore score;
};

struct SuiteReport {
  std::vector<std::string> methods;  ///< in the order of the tables
  std::vector<SuiteResult> results;
  std::size_t cases = 0;      ///< modes of members
  std::size_t undecided = 0;  ///< of these left out: some tetrahedron has no truth
};

/// Scores vtkContourGrid on the mesh itself and subdivided once, twice and three times, and the
/// extractor at its default resolution, against the certified truth of every case. Throws IoError.
SuiteReport run_suite(const std::vector<SuiteEntry>& suite, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const SuiteReport& report);
/// A page in Markdown: what is measured, and tables by kind and by mode.
std::string to_markdown(const SuiteReport& report);

}  // namespace tensortopo
