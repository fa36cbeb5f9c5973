// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace certificate {

/// A file in memory. It is read once, so that what is hashed is what is looked at, even if somebody
/// writes the file meanwhile.
struct File {
  std::string name, bytes;

  /// Whether the name ends so, in capitals or not.
  bool has_extension(std::string_view extension) const;
  /// Frees the memory of the bytes.
  void forget() { bytes.clear(), bytes.shrink_to_fit(); }
};

/// Reads a regular file. Throws Malformed.
File read_file(const std::string& name);

}  // namespace certificate
