// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/frd_scanner.hpp"

#include <algorithm>

#include "bytes/element.hpp"
#include "bytes/format_error.hpp"
#include "bytes/words.hpp"

namespace tensortopo::detail {

std::string_view columns(std::string_view line, std::size_t begin, std::size_t width) {
  return line.substr(std::min(begin, line.size()), width);
}

std::uint64_t count_in(std::string_view line, std::size_t begin, std::size_t width,
                       const char* what) {
  const std::string_view word = trimmed(columns(line, begin, width));
  const auto value = to_count(word);
  if (!value || *value > INT32_MAX)
    throw FormatError("\"" + std::string(word.substr(0, 40)) + "\" is no " + what);
  return *value;
}

double take_real(std::string_view& text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  std::size_t end = text.empty() ? 0 : 1;
  while (end < text.size() && !is_space(text[end])) {
    const bool is_sign = text[end] == '-' || text[end] == '+';
    if (is_sign && text[end - 1] != 'E' && text[end - 1] != 'e') break;
    ++end;
  }
  if (end == 0) throw FormatError("ends a line before its numbers");
  const double value = from_text<double>(text.substr(0, end), ElementType::f64);
  text.remove_prefix(end);
  return value;
}

std::string_view FrdScanner::line() {
  const std::size_t end = rest_.find('\n');
  std::string_view text = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

std::string_view FrdScanner::bytes(std::uint64_t count, std::uint64_t size) {
  if (count > rest_.size() / size) throw FormatError("ends within a block: the file is cut off");
  const std::string_view text = rest_.substr(0, count * size);
  rest_.remove_prefix(count * size);
  return text;
}

std::string_view FrdScanner::text_block() {
  const std::string_view from = rest_;
  for (;;) {
    if (rest_.empty()) throw FormatError("ends within a block: the file is cut off");
    const std::size_t before = rest_.size();
    if (line().starts_with(" -3")) return from.substr(0, from.size() - before);
  }
}

std::string FrdScanner::place() const {
  return "byte " + std::to_string(all_.size() - rest_.size());
}

}  // namespace tensortopo::detail
