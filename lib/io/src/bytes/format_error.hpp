// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "tensortopo/io/io_error.hpp"

namespace tensortopo::detail {

/// Bytes that are not what they should be; the file's name is added by `naming_file`.
class FormatError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs work on a file's content, putting the file's name on what goes wrong, and `place`.
template <class Work>
auto naming_file(const std::filesystem::path& file, const std::string& place, const Work& work) {
  try {
    return work();
  } catch (const FormatError& error) {
    const std::string where = place.empty() ? "" : " (" + place + ")";
    throw IoError(IoError::Kind::invalid, file, error.what() + where);
  }
}

}  // namespace tensortopo::detail
