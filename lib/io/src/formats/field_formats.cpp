// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/field_formats.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "bytes/printable.hpp"
#include "formats/field_format.hpp"
#include "formats/read_exodus.hpp"
#include "formats/read_frd.hpp"
#include "formats/read_legacy.hpp"
#include "formats/read_nifti.hpp"
#include "formats/read_pvd.hpp"
#include "formats/read_vti.hpp"
#include "formats/read_vtu.hpp"
#include "tensortopo/io/field_steps.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"

namespace tensortopo {
namespace detail {
namespace {

std::vector<RawGrid> read_pieces(const FieldSource& source) {
  const std::filesystem::path& index = source.file->path;
  std::vector<RawGrid> grids;
  std::set<std::filesystem::path> seen;
  for (const auto& path : read_pvtu(source.file)) {
    const auto piece = load(path);
    if (!seen.insert(std::filesystem::canonical(path)).second)
      throw IoError(IoError::Kind::invalid, index,
                    "names a piece twice (" + path.filename().string() + ")");
    source.sum.add(piece->bytes);
    for (RawGrid& grid : read_vtu(piece)) grids.push_back(std::move(grid));
  }
  return grids;
}

std::vector<RawGrid> read_one_vtu(const FieldSource& source) {
  return read_vtu(source.file);
}

std::vector<RawGrid> read_one_legacy(const FieldSource& source) {
  std::vector<RawGrid> grids;
  grids.push_back(read_legacy(source));
  return grids;
}

}  // namespace

const std::vector<FieldFormatEntry>& field_format_entries() {
  static const std::vector<FieldFormatEntry> entries{
      {{.extension = ".vtu", .name = "VTK XML mesh", .fuzzed_as = "vtu"}, read_one_vtu},
      {{.extension = ".pvtu", .name = "VTK XML mesh in pieces", .fuzzed_as = "pvtu", .names_files = true}, read_pieces},
      {{.extension = ".vtk", .name = "VTK legacy mesh or image", .fuzzed_as = "vtk"},
       read_one_legacy},
      {{.extension = ".vti", .name = "VTK XML image", .fuzzed_as = "vti"}, read_vti},
      {{.extension = ".pvd", .name = "VTK XML collection", .fuzzed_as = "pvd", .has_steps = true, .names_files = true},
       read_pvd,
       pvd_steps},
      {{.extension = ".frd", .name = "CalculiX results", .fuzzed_as = "frd", .has_steps = true},
       read_frd,
       frd_steps},
      {{.extension = ".e", .name = "Exodus II results", .fuzzed_as = "exo", .has_steps = true},
       read_exodus,
       exodus_steps},
      {{.extension = ".exo", .name = "Exodus II results", .fuzzed_as = "exo", .has_steps = true},
       read_exodus,
       exodus_steps},
      {{.extension = ".nii", .name = "NIfTI image", .fuzzed_as = "nii", .takes_mask = true}, read_nifti},
      {{.extension = ".nii.gz", .name = "NIfTI image, packed", .fuzzed_as = "nii", .takes_mask = true}, read_nifti},
  };
  return entries;
}

namespace {

const FieldFormatEntry* find_entry(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const FieldFormatEntry& entry : field_format_entries())
    if (name.size() > entry.format.extension.size() && name.ends_with(entry.format.extension))
      return &entry;
  return nullptr;
}

}  // namespace

const FieldFormatEntry& format_of(const std::filesystem::path& file) {
  if (const FieldFormatEntry* const entry = find_entry(file)) return *entry;
  if (std::error_code error; std::filesystem::is_directory(file, error))
    throw IoError(IoError::Kind::invalid, file, "is a folder");
  throw IoError(IoError::Kind::invalid, file,
                "has the unknown extension \"" + lower_extension(file) + "\"; known are " +
                    field_extensions());
}

std::size_t chosen_step(const FieldSource& source, const std::vector<std::string>& texts) {
  const std::size_t asked = source.options.step.value_or(texts.size());
  if (asked == 0 || asked > texts.size())
    throw IoError(IoError::Kind::inapplicable, source.file->path,
                  fmt::format("--step {}: the file has the steps 1 to {}", asked, texts.size()));
  if (texts.size() > 1)
    source.notes.push_back(fmt::format("step {} of {} taken{} ({})", asked, texts.size(),
                                       source.options.step ? "" : ", the last",
                                       texts[asked - 1]));
  return asked - 1;
}

}  // namespace detail

const std::vector<FieldFormat>& field_formats() {
  static const std::vector<FieldFormat> formats = [] {
    std::vector<FieldFormat> list;
    for (const auto& entry : detail::field_format_entries()) list.push_back(entry.format);
    return list;
  }();
  return formats;
}

const FieldFormat* field_format_of(const std::filesystem::path& file) {
  const detail::FieldFormatEntry* const entry = detail::find_entry(file);
  return entry != nullptr ? &entry->format : nullptr;
}

std::vector<std::string> field_steps(const std::filesystem::path& file) {
  const detail::FieldFormatEntry& entry = detail::format_of(file);
  if (entry.steps == nullptr)
    throw IoError(IoError::Kind::inapplicable, file,
                  fmt::format("a {} has no steps", entry.format.extension));
  std::vector<std::string> texts = entry.steps(detail::load(file));
  for (std::string& text : texts) text = detail::printable(std::move(text));
  return texts;
}

const std::string& field_extensions() {
  static const std::string text = [] {
    std::string list;
    for (const FieldFormat& format : field_formats())
      list += (list.empty() ? "" : ", ") + std::string(format.extension);
    return list;
  }();
  return text;
}

}  // namespace tensortopo
