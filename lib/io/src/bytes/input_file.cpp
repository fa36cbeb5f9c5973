// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/input_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include <unistd.h>

#include "bytes/format_error.hpp"

namespace tensortopo::detail {

std::shared_ptr<const InputFile> load(const std::filesystem::path& path) {
  const auto fail = [&](const std::string& why) -> IoError {
    return {IoError::Kind::unreadable, path, "cannot be read: " + why};
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) throw fail("no such file");
  if (error) throw fail(error.message());
  if (!std::filesystem::is_regular_file(status)) throw fail("not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw fail(error.message());

  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw fail(std::strerror(errno));
  auto file = std::make_shared<InputFile>(InputFile{path, {}});
  file->bytes.resize(size);
  stream.read(file->bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(stream.gcount()) != size) throw fail("it ends before its size");
  return file;
}

void require_memory(std::uint64_t points, std::uint64_t cells, std::uint64_t corners) {
  constexpr std::uint64_t most = INT32_MAX;  // TetMesh::Index
  if (points > most || cells > most)
    throw FormatError("has " + std::to_string(points) + " points and " + std::to_string(cells) +
                      " cells; at most " + std::to_string(most) + " of each are possible");
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  if (pages <= 0 || page <= 0) return;
  const std::uint64_t memory = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
  constexpr std::uint64_t per_point = 120, per_cell = 42, per_corner = 16;  // bytes at the peak
  if (points * per_point > memory || cells * per_cell > memory || corners > memory / per_corner ||
      points * per_point + cells * per_cell + corners * per_corner > memory)
    throw FormatError("promises " + std::to_string(points) + " points and " +
                      std::to_string(cells) + " cells, more than this machine's memory holds");
}

}  // namespace tensortopo::detail
