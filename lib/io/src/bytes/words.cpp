// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/words.hpp"

#include <charconv>
#include <string>

#include "bytes/format_error.hpp"

namespace tensortopo::detail {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view take_word(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_space(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !is_space(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::optional<std::uint64_t> to_count(std::string_view word) {
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc{} || stop != word.data() + word.size())
    return std::nullopt;
  return value;
}

template <class Value>
std::vector<Value> take_numbers(std::string_view& text, std::size_t count, ElementType type) {
  // Two characters a number at least: room is made for no more than the text can hold.
  if (count > text.size() / 2 + 1)
    throw FormatError("ends before " + std::to_string(count) + " numbers");
  std::vector<Value> values;
  values.reserve(count);
  while (values.size() < count) {
    const std::string_view word = take_word(text);
    if (word.empty())
      throw FormatError("holds " + std::to_string(values.size()) + " numbers where " +
                        std::to_string(count) + " belong");
    values.push_back(from_text<Value>(word, type));
  }
  return values;
}

template std::vector<double> take_numbers(std::string_view&, std::size_t, ElementType);
template std::vector<std::int64_t> take_numbers(std::string_view&, std::size_t, ElementType);

}  // namespace tensortopo::detail
