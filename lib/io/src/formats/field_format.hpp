// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bytes/input_file.hpp"
#include "grids/raw_grid.hpp"
#include "tensortopo/hash/sha256.hpp"
#include "tensortopo/io/field_formats.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo::detail {

/// What a reader of fields is given, and where it says what else it did.
struct FieldSource {
  std::shared_ptr<const InputFile> file;
  const ReadOptions& options;
  Sha256& sum;                      ///< has the file's bytes; those of further files are added
  std::vector<std::string>& notes;  ///< one line each
};

/// The grids of a file: the format's, not the mesh's business. Throws IoError.
using FieldReader = std::vector<RawGrid> (*)(const FieldSource& source);

/// A row of the table of formats that fields are read from.
struct FieldFormatEntry {
  FieldFormat format;
  FieldReader read;
  /// What each step of a file is; null for formats without steps.
  std::vector<std::string> (*steps)(const std::shared_ptr<const InputFile>& file) = nullptr;
};

/// The table, which all else about formats is taken from; of formats with several extensions one row each.
const std::vector<FieldFormatEntry>& field_format_entries();

/// The row of a file by its name. Throws IoError, with all extensions that there are.
const FieldFormatEntry& format_of(const std::filesystem::path& file);

/// The number (from 0) of the step that `options.step` asks for, by default the last. `texts` tells
/// what each one is. Adds a note if there are several. Throws IoError if there are not as many.
std::size_t chosen_step(const FieldSource& source, const std::vector<std::string>& texts);

}  // namespace tensortopo::detail
