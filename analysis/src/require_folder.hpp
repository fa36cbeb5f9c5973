// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <system_error>

#include "tensortopo/io/io_error.hpp"

namespace tensortopo {

/// An extraction may take minutes: a folder that is not there is found out before it.
inline void require_folder(const std::filesystem::path& output) {
  const auto folder = output.has_parent_path() ? output.parent_path() : ".";
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    throw IoError(IoError::Kind::unwritable, output, "no such folder");
  }
  if (std::filesystem::is_directory(output, error)) {
    throw IoError(IoError::Kind::unwritable, output, "is a folder");
  }
}

}  // namespace tensortopo
