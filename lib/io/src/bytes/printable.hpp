// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tensortopo::detail {

/// The text with `?` for each control character: names in files are anything, and a terminal obeys
/// them.
std::string printable(std::string text);

}  // namespace tensortopo::detail
