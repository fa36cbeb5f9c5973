// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtk/legacy_scanner.hpp"

#include <algorithm>
#include <cctype>

#include "bytes/format_error.hpp"
#include "bytes/words.hpp"

namespace tensortopo::detail {

template <class Value>
std::vector<Value> LegacyNumbers::decode() const {
  if (binary) return from_bytes<Value>(text, type, std::endian::big);
  std::string_view rest = text;
  return take_numbers<Value>(rest, count, type);
}

template std::vector<double> LegacyNumbers::decode() const;
template std::vector<std::int64_t> LegacyNumbers::decode() const;

std::string_view LegacyScanner::line() {
  const std::size_t end = rest_.find('\n');
  std::string_view text = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

std::string_view LegacyScanner::word() { return take_word(rest_); }

std::string LegacyScanner::peek_keyword() {
  std::string_view ahead = rest_;
  std::string keyword(take_word(ahead).substr(0, 64));
  std::transform(keyword.begin(), keyword.end(), keyword.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return keyword;
}

std::size_t LegacyScanner::count(const char* what) {
  const std::string_view text = word();
  const auto value = to_count(text);
  if (!value)
    throw FormatError("\"" + std::string(text.substr(0, 40)) + "\" is not a number of " + what);
  return *value;
}

ElementType LegacyScanner::type() {
  const std::string_view name = word();
  const auto type = legacy_element_type(name);
  if (!type) throw FormatError("has the unknown type \"" + std::string(name.substr(0, 40)) + "\"");
  return *type;
}

LegacyNumbers LegacyScanner::numbers(std::uint64_t count, ElementType type) {
  LegacyNumbers numbers{{}, type, count, binary_};
  if (binary_) {
    end_header_line();
    const std::size_t size = size_of(type);
    if (count > rest_.size() / size)
      throw FormatError("ends before " + std::to_string(count) + " numbers");
    numbers.text = bytes(count * size);
  } else {
    numbers.text = rest_;
    skip_words(count);
    numbers.text.remove_suffix(rest_.size());
  }
  return numbers;
}

void LegacyScanner::skip_bits(std::uint64_t count) {
  if (!binary_) return skip_words(count);
  end_header_line();
  bytes(count / 8 + (count % 8 != 0));
}

void LegacyScanner::skip_strings(std::uint64_t count) {
  end_header_line();
  if (count > rest_.size()) throw FormatError("ends before " + std::to_string(count) + " strings");
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!binary_) {
      line();
      continue;
    }
    // The two highest bits of the first byte tell how many bytes the length takes.
    const auto first = static_cast<unsigned char>(bytes(1).front());
    const std::uint64_t more = first >> 6 == 3 ? 0 : first >> 6 == 2 ? 1 : first >> 6 == 1 ? 3 : 7;
    std::uint64_t length = first & 63u;
    for (const char c : bytes(more)) length = length << 8 | static_cast<unsigned char>(c);
    bytes(length);
  }
}

std::string LegacyScanner::place() const {
  const std::string_view read = all_.substr(0, all_.size() - rest_.size());
  if (binary_) return "byte " + std::to_string(read.size());
  return "line " + std::to_string(1 + std::count(read.begin(), read.end(), '\n'));
}

std::string_view LegacyScanner::bytes(std::uint64_t size) {
  if (size > rest_.size()) throw FormatError("ends within an array's bytes");
  const std::string_view text = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return text;
}

void LegacyScanner::end_header_line() {
  if (!trimmed(line()).empty()) throw FormatError("has more in a header line than belongs there");
}

void LegacyScanner::skip_words(std::uint64_t count) {
  if (count > rest_.size() / 2 + 1)
    throw FormatError("ends before " + std::to_string(count) + " numbers");
  for (std::uint64_t i = 0; i < count; ++i)
    if (word().empty()) throw FormatError("ends before " + std::to_string(count) + " numbers");
}

}  // namespace tensortopo::detail
