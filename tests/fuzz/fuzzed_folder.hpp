// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tensortopo::test {

/// A folder for this process, in memory if there is a place for that.
class FuzzedFolder {
 public:
  FuzzedFolder();
  ~FuzzedFolder();
  FuzzedFolder(const FuzzedFolder&) = delete;
  FuzzedFolder& operator=(const FuzzedFolder&) = delete;

  /// Writes the bytes to the file of that name in the folder. Returns its path.
  std::string put(const char* name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

/// The one of this process.
const FuzzedFolder& fuzzed_folder();

}  // namespace tensortopo::test
