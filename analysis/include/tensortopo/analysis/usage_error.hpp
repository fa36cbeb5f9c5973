// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace tensortopo {

/// The caller asked for something that makes no sense, or that this version does not do.
/// what() is one line without the program's name.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tensortopo
