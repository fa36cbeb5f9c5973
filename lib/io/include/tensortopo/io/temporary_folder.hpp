// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace tensortopo {

namespace detail {
struct Noted;
}

/// A folder of our own where temporary files belong, gone at the end with all that is in it. A
/// signal that ends the process removes it too, if there are no files in it but those that `file`
/// named (see `remove_unfinished_files`).
class TemporaryFolder {
 public:
  /// Throws IoError (unwritable).
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// The path of a file in it, that is yet to be made.
  std::filesystem::path file(const std::filesystem::path& name);

 private:
  std::filesystem::path path_;
  std::vector<detail::Noted*> noted_;
};

}  // namespace tensortopo
