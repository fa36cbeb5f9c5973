// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/legacy_lines.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <map>

#include "certificate_check/check_certificate.hpp"
#include "files/word_number.hpp"

namespace certificate {
namespace {

constexpr std::size_t kLongestLine = 250;

/// A number from its bytes, the highest first.
double from_bytes(const char* bytes, LegacyType type) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < type.size; ++i)
    bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
  const std::size_t unused = 64 - 8 * type.size;
  if (type.kind == LegacyType::natural) return in_double(bits);
  if (type.kind == LegacyType::whole)
    return in_double(static_cast<std::int64_t>(bits << unused) >> unused);
  return type.size == 8 ? std::bit_cast<double>(bits)
                        : std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}

std::optional<double> from_word(std::string_view word, LegacyType type) {
  const bool is_natural = type.kind == LegacyType::natural;
  if (type.kind == LegacyType::real)
    return type.size == 8 ? number_of_word<double>(word) : number_of_word<float>(word);
  switch (type.size) {
    case 1: return is_natural ? number_of_word<std::uint8_t>(word) : number_of_word<std::int8_t>(word);
    case 2: return is_natural ? number_of_word<std::uint16_t>(word) : number_of_word<std::int16_t>(word);
    case 4: return is_natural ? number_of_word<std::uint32_t>(word) : number_of_word<std::int32_t>(word);
    default: return is_natural ? number_of_word<std::uint64_t>(word) : number_of_word<std::int64_t>(word);
  }
}

bool is_blank(std::string_view line) { return line.find_first_not_of(' ') == line.npos; }

}  // namespace

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

void LegacyLines::fail(const std::string& what) const { throw Malformed(file_, what); }

std::string_view LegacyLines::line() {
  if (rest_.empty()) fail("ends too early");
  std::string_view text = rest_.substr(0, rest_.find('\n'));
  rest_.remove_prefix(std::min(text.size() + 1, rest_.size()));
  if (text.ends_with('\r')) text.remove_suffix(1);
  if (text.size() > kLongestLine) fail("a line that is too long");
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) fail("a control character");
  return text;
}

LegacyLines::Words LegacyLines::words_in(std::string_view line) const {
  if (line.ends_with(' ')) line.remove_suffix(1);
  Words result;
  for (std::size_t at = 0; at <= line.size(); at += result.back().size() + 1) {
    result.push_back(line.substr(at, line.find(' ', at) - at));
    if (result.back().empty()) fail("words of a line that are not apart by one space");
  }
  return result;
}

LegacyLines::Words LegacyLines::words() {
  while (!rest_.empty()) {
    if (const std::string_view text = line(); !is_blank(text)) return words_in(text);
  }
  return {};
}

LegacyLines::Words LegacyLines::words(std::size_t count) {
  Words result = words();
  if (result.size() != count) fail("a line of other than " + std::to_string(count) + " words");
  return result;
}

std::vector<double> LegacyLines::numbers(std::size_t count, LegacyType type) {
  if (count == 0) return {};
  if (count > rest_.size() / (binary_ ? type.size : 1)) fail("numbers that end too early");
  std::vector<double> result(count);
  if (binary_) {
    for (std::size_t i = 0; i < count; ++i) result[i] = from_bytes(&rest_[i * type.size], type);
    rest_.remove_prefix(count * type.size);
  } else {
    for (double& x : result) {
      rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
      const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r\n"));
      const auto number = from_word(word, type);
      if (!number) fail("text that is no number of its type, or numbers that end too early");
      x = *number;
      rest_.remove_prefix(word.size());
    }
  }
  if (!rest_.empty() && !is_blank(line())) fail("more on a line than its numbers");
  return result;
}

void LegacyLines::skip_texts(std::size_t count) {
  const auto skip = [&](std::uint64_t bytes) {
    if (bytes > rest_.size()) fail("data that end too early");
    rest_.remove_prefix(bytes);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (rest_.empty()) fail("data that end too early");
    if (!binary_) {
      skip(std::min(rest_.find('\n'), rest_.size() - 1) + 1);
      continue;
    }
    // The two highest bits of the first byte tell how many bytes the length takes.
    const auto first = static_cast<unsigned char>(rest_.front());
    const std::size_t more = (std::size_t{8} >> (first >> 6)) - 1;
    if (more >= rest_.size()) fail("data that end too early");
    std::uint64_t length = first & 63u;
    for (std::size_t k = 1; k <= more; ++k)
      length = length << 8 | static_cast<unsigned char>(rest_[k]);
    skip(1 + more);
    skip(length);
  }
  if (binary_ && count > 0 && !rest_.empty() && !is_blank(line())) fail("more than its texts");
}

std::size_t LegacyLines::natural(std::string_view word) const {
  std::size_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || last != end || value > most_) fail("a count that is none, or more than the file can hold");
  return value;
}

LegacyType LegacyLines::type(std::string_view word) const {
  using enum LegacyType::Kind;
  static const std::map<std::string, LegacyType> types{
      {"double", {real, 8}},         {"float", {real, 4}},          {"char", {whole, 1}},
      {"signed_char", {whole, 1}},   {"unsigned_char", {natural, 1}}, {"short", {whole, 2}},
      {"unsigned_short", {natural, 2}}, {"int", {whole, 4}},        {"unsigned_int", {natural, 4}},
      {"vtktypeint64", {whole, 8}},  {"vtktypeuint64", {natural, 8}}, {"vtkidtype", {whole, 4}},
      {"string", {text, 1}},         {"utf8_string", {text, 1}}};
  const auto found = types.find(lower_case(word));
  if (found == types.end())
    fail("an array of type '" + std::string(word) +
         "', which not all readers read alike; tensortopo convert makes a file without");
  return found->second;
}

std::string LegacyLines::name(std::string_view word) const {
  std::string result;
  for (std::size_t i = 0; i < word.size(); ++i) {
    result += word[i];
    if (word[i] != '%') continue;
    unsigned code = 0;
    const char* const digits = word.data() + i + 1;
    if (i + 2 >= word.size() || std::from_chars(digits, digits + 2, code, 16).ptr != digits + 2)
      fail("a name with '%' that no two hexadecimal digits follow");
    if (code < 0x20 || code == 0x7f) fail("a control character");
    result.back() = static_cast<char>(code), i += 2;
  }
  return result;
}

}  // namespace certificate
