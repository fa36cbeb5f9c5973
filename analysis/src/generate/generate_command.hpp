// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generate/truth.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/families/field_family.hpp"

namespace tensortopo {

/// Fields of a family, with the certified truth about their mode surfaces.
struct GenerateCommand {
  FieldKind kind = FieldKind::linear;
  std::filesystem::path output;  ///< .vtu; of pieces .pvtu
  std::uint64_t seed = 1;
  int count = 1;                  ///< members of the family
  bool together = false;          ///< all members in one file, side by side
  std::size_t tetrahedra = 0;     ///< of each member, where the kind allows; 0: the kind's default
  std::vector<ModeValue> modes;   ///< none: those of the kind
  bool field_only = false;        ///< no truth
  bool no_reference = false;      ///< no reference surface
  bool always_reference = false;  ///< a reference surface also above kLargeMesh
  double resolution = 8;          ///< of the reference surface
  int pieces = 1;                 ///< files that the field is written to, none longer in memory
};

/// Above so many tetrahedra the truth is that of the whole surfaces only.
inline constexpr std::size_t kLargeMesh = 10000;

/// One file pair that was written.
struct Generated {
  std::filesystem::path field, truth_file;
  FieldTruth truth;  ///< levels are empty with `field_only`
  std::vector<std::string> notes;
};

struct GenerateReport {
  FieldKind kind = FieldKind::linear;
  std::vector<Generated> files;
};

/// Makes the members and writes each as FILE.vtu (with more than one: FILE-0000.vtu and so on) with
/// its truth beside it as FILE.truth.json, the reference surface as FILE.reference.vtp (all modes)
/// and its vertices to 36 digits as FILE.reference.json.
///
/// A field in pieces is written as FILE-0000.vtu and so on, and their list FILE.pvtu; without truth.
///
/// Laws      the bytes of the fields depend on the command only; those of truths also on the
///           library's version.
/// Throws    UsageError, IoError.
GenerateReport run_generate(const GenerateCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const GenerateReport& report);
/// A table for people. Ends with a newline.
std::string to_text(const GenerateReport& report);

}  // namespace tensortopo
