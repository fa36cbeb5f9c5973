// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tensortopo::filters {

/// Where the files of a certificate of parts are: beside it, those of parts in a folder of its name.
struct PartsFiles {
  std::filesystem::path certificate;  ///< NAME.json
  std::filesystem::path output;       ///< NAME.pvtp
  std::filesystem::path field;        ///< NAME_field.pvtu
  std::filesystem::path folder;       ///< NAME, for the files of parts

  /// @throws std::runtime_error unless the name ends in .json
  explicit PartsFiles(const std::string& certificate_file);

  // Names of a part's files in the folder.
  std::string field_of(std::size_t part) const;
  std::string output_of(std::size_t part) const;
  std::string certificate_of(std::size_t part) const;
  /// A name in the folder, as files beside the folder have it.
  std::string below(const std::string& name) const;

  /// @throws std::runtime_error with the path and the remedy, if files would take the place of what
  ///         is no certificate of parts, or if nothing can be written there
  void require_place() const;
};

/// A hidden folder beside another one, to be filled and put in its place; else gone in the end, with
/// all that is in it.
class NewFolder {
 public:
  /// @throws std::runtime_error
  explicit NewFolder(std::filesystem::path place);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Takes its place, together with files beside it; or all is as before.
  /// @param files  and their bytes; the last one appears last
  /// @throws std::runtime_error
  void put_in_place(const std::vector<std::pair<std::filesystem::path, std::string>>& files);

 private:
  std::filesystem::path place_, path_;
};

/// Writes a file; throws std::runtime_error that names `named`.
void write_bytes(const std::filesystem::path& file, const std::string& bytes,
                 const std::filesystem::path& named);

}  // namespace tensortopo::filters
