// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace tensortopo::detail {

/// A file and all its bytes.
struct InputFile {
  std::filesystem::path path;
  std::string bytes;
};

/// Reads a whole regular file; throws IoError (unreadable).
std::shared_ptr<const InputFile> load(const std::filesystem::path& path);

/// Refuses (FormatError) a mesh that no machine like this one could hold: a header may promise
/// anything, and compressed zeros cost a file nothing.
void require_memory(std::uint64_t points, std::uint64_t cells, std::uint64_t corners);

}  // namespace tensortopo::detail
