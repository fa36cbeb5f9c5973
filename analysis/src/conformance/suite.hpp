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

/// Members of a family that belong to a suite.
struct SuiteEntry {
  FieldKind kind = FieldKind::linear;
  std::uint64_t seed = 1;
  int count = 1;
  std::size_t tetrahedra = 0;    ///< of each; 0: the kind's default
  std::vector<ModeValue> modes;  ///< none: those of the member
};

/// The suite that a JSON file lists: {"suite": [{"kind", "seed", "count", "tetrahedra"?, "modes"?},
/// ...]}. Throws IoError.
std::vector<SuiteEntry> read_suite(const std::filesystem::path& file);

/// What a method got wrong in one case, a mode of one member.
struct SuiteResult {
  FieldKind kind = FieldKind::linear;
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
/// extractor at its default resolution, against the certified truth of every case.
SuiteReport run_suite(const std::vector<SuiteEntry>& suite, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const SuiteReport& report);
/// A page in Markdown: what is measured, and tables by kind and by mode.
std::string to_markdown(const SuiteReport& report);

}  // namespace tensortopo
