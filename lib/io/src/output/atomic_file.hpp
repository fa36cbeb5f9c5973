// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

namespace tensortopo::detail {

struct UnfinishedFile;
struct UnfinishedFiles;

/// A file in the making, whole or not at all: what is appended goes to a file of another name in
/// the same folder, which is then renamed (a device or pipe is written as it is). Without `finish`
/// that file is removed. While a `FileGroup` lives in this thread, the renaming is left to it.
class OutputFile {
 public:
  /// Throws IoError (unwritable).
  explicit OutputFile(std::filesystem::path file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Throws IoError (unwritable).
  void append(std::string_view bytes);
  /// All is there. Throws IoError (unwritable).
  void finish();
  /// The number of bytes appended.
  std::size_t size() const { return size_; }

 private:
  /// Calls `act`; an error of the system is one of this file.
  template <class Act>
  void naming_file(const Act& act) const;

  std::filesystem::path file_;
  std::unique_ptr<UnfinishedFiles> alone_;  ///< the group, if this thread has none
  UnfinishedFiles* group_ = nullptr;
  UnfinishedFile* unfinished_ = nullptr;  ///< of the group; null for devices and pipes
  int descriptor_ = -1;                   ///< -1 at last
  std::size_t size_ = 0;
};

/// Makes a file of these bytes, as `OutputFile`.
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace tensortopo::detail
