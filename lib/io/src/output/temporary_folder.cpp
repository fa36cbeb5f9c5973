// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/temporary_folder.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>

#include "output/noted_names.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo {

TemporaryFolder::TemporaryFolder() {
  static std::atomic<unsigned> counter{0};
  std::error_code problem;
  const auto parent = std::filesystem::temp_directory_path(problem);
  if (problem)
    throw IoError(IoError::Kind::unwritable, "the folder for temporary files (TMPDIR)",
                  "cannot be used: " + problem.message());
  for (int tries = 0;; ++tries) {
    path_ = parent /
            ("tensortopo-" + std::to_string(getpid()) + "-" + std::to_string(counter++) + ".tmp");
    // Noted first: a signal may come as soon as the folder is there.
    detail::Noted* const noted = detail::note(path_, detail::NotedKind::folder);
    if (mkdir(path_.c_str(), 0700) == 0) {
      noted_.push_back(noted);
      return;
    }
    const int error = errno;
    detail::forget(noted);
    if (error != EEXIST || tries == 1000)
      throw IoError(IoError::Kind::unwritable, path_,
                    "cannot make a folder: " + std::generic_category().message(error));
  }
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  for (detail::Noted* const noted : noted_) detail::forget(noted);
}

std::filesystem::path TemporaryFolder::file(const std::filesystem::path& name) {
  const std::filesystem::path path = path_ / name;
  noted_.push_back(detail::note(path, detail::NotedKind::file));
  return path;
}

}  // namespace tensortopo
