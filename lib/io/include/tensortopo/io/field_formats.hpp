// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tensortopo {

/// A file format that `read_mesh` takes.
struct FieldFormat {
  std::string_view extension;  ///< in lower case, with its dot; may be of two parts (`.nii.gz`)
  std::string_view name;       ///< for people
  std::string_view fuzzed_as;  ///< the target in tests/fuzz
  bool has_steps = false;      ///< may hold several states of a field, see `ReadOptions::step`
  bool names_files = false;    ///< holds the names of files that hold the field
  bool takes_mask = false;     ///< see `ReadOptions::mask`
};

/// All formats of fields: the one table that readers, messages, help texts and tests take them
/// from.
const std::vector<FieldFormat>& field_formats();

/// The format of a file by its name; null if there is none.
const FieldFormat* field_format_of(const std::filesystem::path& file);

/// ".vtu, .pvtu, ...", for messages.
const std::string& field_extensions();

}  // namespace tensortopo
