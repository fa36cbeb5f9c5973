// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/base64.hpp"

#include <array>
#include <cstdint>

#include "bytes/format_error.hpp"

namespace tensortopo::detail {
namespace {

constexpr std::int8_t space = -1, padding = -2, other = -3;

constexpr std::array<std::int8_t, 256> make_table() {
  std::array<std::int8_t, 256> table{};
  for (auto& entry : table) entry = other;
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < digits.size(); ++i)
    table[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
  for (const char c : {' ', '\t', '\n', '\r'}) table[static_cast<unsigned char>(c)] = space;
  table['='] = padding;
  return table;
}

constexpr auto table = make_table();

}  // namespace

std::string from_base64(std::string_view text, bool prefix) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int digits = 0, pads = 0;
  for (const char c : text) {
    const std::int8_t value = table[static_cast<unsigned char>(c)];
    if (value == space) continue;
    if (value == other) {
      if (prefix) break;
      throw FormatError("holds a character that is not base64");
    }
    if (value == padding) {
      ++pads;
    } else if (pads > 0) {
      throw FormatError("base64 goes on after its padding");
    }
    bits = bits << 6 | static_cast<std::uint32_t>(value == padding ? 0 : value);
    if (++digits < 4) continue;
    if (pads > 2) throw FormatError("base64 has too much padding");
    for (int i = 0; i < 3 - pads; ++i) bytes += static_cast<char>(bits >> (16 - 8 * i) & 0xff);
    bits = 0, digits = pads = 0;
  }
  if (digits != 0 && !prefix) throw FormatError("base64 ends in the middle of a group");
  return bytes;
}

}  // namespace tensortopo::detail
