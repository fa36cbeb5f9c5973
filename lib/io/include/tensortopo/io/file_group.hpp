// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

namespace tensortopo {

namespace detail {
struct UnfinishedFiles;
}

/// Files that appear together or not at all.
///
/// While a group lives, what this thread writes (`write_surface`, `write_mesh`, `write_text`) stays
/// under temporary names beside its places. `commit` gives each file its name; without it the
/// destructor removes them, and what was there before is untouched. Devices and pipes are written
/// at once. What a group within another one commits is the outer one's from then on, unless it is
/// `apart`: then it is as if there were no other.
class FileGroup {
 public:
  /// Whether a group within another one is part of it.
  enum class Bond { joined, apart };

  /// What this thread writes from now on belongs to the group.
  explicit FileGroup(Bond bond = Bond::joined);
  ~FileGroup();
  FileGroup(const FileGroup&) = delete;
  FileGroup& operator=(const FileGroup&) = delete;

  /// Throws IoError (unwritable) if a file cannot get its name; those before it have theirs then.
  void commit();

 private:
  std::unique_ptr<detail::UnfinishedFiles> files_;
  detail::UnfinishedFiles* outer_;
  Bond bond_;
};

/// Removes all files of temporary names that this process is writing, and its temporary folders
/// (`TemporaryFolder`), for the handler of a signal that ends it: makes nothing but system calls.
void remove_unfinished_files() noexcept;

}  // namespace tensortopo
