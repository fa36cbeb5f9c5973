// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "bytes/element.hpp"

namespace tensortopo::detail {

constexpr bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Without white space at both ends.
std::string_view trimmed(std::string_view text);

/// Takes the next word off the front of `text`; empty at the end.
std::string_view take_word(std::string_view& text);

/// A count: digits only.
std::optional<std::uint64_t> to_count(std::string_view word);

/// The next `count` numbers, taken off the front of `text`. Throws FormatError if there are fewer.
template <class Value>
std::vector<Value> take_numbers(std::string_view& text, std::size_t count, ElementType type);

}  // namespace tensortopo::detail
