// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>

namespace tensortopo {

/// Adds formatted text to the end of another. (`fmt::format_to` would compile all of the formatting
/// anew in each source that calls it; this calls that of fmt's library.)
template <class... Arguments>
void append_format(std::string& text, fmt::format_string<Arguments...> format,
                   const Arguments&... arguments) {
  text += fmt::vformat(format, fmt::make_format_args(arguments...));
}

}  // namespace tensortopo
