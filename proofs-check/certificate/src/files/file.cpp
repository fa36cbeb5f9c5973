// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/file.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "certificate_check/check_certificate.hpp"

namespace certificate {

bool File::has_extension(std::string_view extension) const {
  const std::string_view end =
      std::string_view(name).substr(name.size() - std::min(name.size(), extension.size()));
  return std::equal(end.begin(), end.end(), extension.begin(), extension.end(),
                    [](unsigned char c, unsigned char d) { return std::tolower(c) == d; });
}

File read_file(const std::string& name) {
  std::error_code error;
  const auto status = std::filesystem::status(name, error);
  if (!std::filesystem::exists(status)) throw Malformed(name, "cannot be read: no such file");
  // A pipe or device may never end.
  if (!std::filesystem::is_regular_file(status)) throw Malformed(name, "is no regular file");
  std::ifstream stream(name, std::ios::binary);
  const auto size = std::filesystem::file_size(name, error);
  if (!stream.is_open() || error) throw Malformed(name, "cannot be read");
  File file{name, std::string(size, '\0')};
  stream.read(file.bytes.data(), static_cast<std::streamsize>(size));
  if (stream.bad()) throw Malformed(name, "cannot be read");
  file.bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return file;
}

}  // namespace certificate
