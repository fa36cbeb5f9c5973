// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "file_bytes.hpp"

#include <fstream>
#include <iterator>

#include "tensortopo/io/io_error.hpp"

namespace tensortopo::scenarios {

std::string file_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || !std::filesystem::is_regular_file(file))
    throw IoError(IoError::Kind::unreadable, file, "cannot be read; did the solve end well?");
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw IoError(IoError::Kind::unreadable, file, "cannot be read to its end");
  return bytes;
}

}  // namespace tensortopo::scenarios
