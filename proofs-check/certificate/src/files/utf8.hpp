// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace certificate {

/// How many bytes the first character of a text takes in UTF-8; 0 if none begins there.
/// @pre the text is not empty
std::size_t length_of_character(std::string_view text);

}  // namespace certificate
