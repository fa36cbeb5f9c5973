// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iostream>
#include <string_view>

#include "tensortopo/io/io_error.hpp"

namespace tensortopo {

/// Writes to standard output, and means it. Throws IoError.
inline void print(std::string_view text) {
  std::cout << text << std::flush;
  if (!std::cout) throw IoError(IoError::Kind::unwritable, "standard output", "cannot write");
}

}  // namespace tensortopo
