// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/base64.hpp"

#include <array>
#include <cstdint>

#include "bytes/format_error.hpp"

namespace tensortopo::detail {
namespace {

constexpr std::int8_t kSpace = -1, kPadding = -2, kOther = -3;

constexpr std::array<std::int8_t, 256> make_table() {
  std::array<std::int8_t, 256> table{};
  for (auto& entry : table) entry = kOther;
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < digits.size(); ++i)
    table[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
  for (const char c : {' ', '\t', '\n', '\r'}) table[static_cast<unsigned char>(c)] = kSpace;
  table['='] = kPadding;
  return table;
}

constexpr auto table = make_table();

}  // namespace

std::string from_base64(std::string_view text, bool prefix) {
  std::string bytes(text.size() / 4 * 3 + 3, '\0');
  char* out = bytes.data();
  std::uint32_t bits = 0;
  int digits = 0, pads = 0;
  const auto write = [&](int count) {
    for (int i = 0; i < count; ++i) *out++ = static_cast<char>(bits >> (16 - 8 * i) & 0xff);
  };
  const auto value_at = [&](std::size_t i) { return table[static_cast<unsigned char>(text[i])]; };
  for (std::size_t i = 0; i < text.size(); ++i) {
    // Mostly there are four digits.
    while (digits == 0 && text.size() - i > 4) {
      const int a = value_at(i), b = value_at(i + 1), c = value_at(i + 2), d = value_at(i + 3);
      if ((a | b | c | d) < 0) break;
      bits = static_cast<std::uint32_t>(a << 18 | b << 12 | c << 6 | d);
      write(3);
      i += 4;
    }
    const int value = value_at(i);
    if (value == kSpace) continue;
    if (value == kOther) {
      if (prefix) break;
      throw FormatError("holds a character that is not base64");
    }
    if (value == kPadding) {
      ++pads;
    } else if (pads > 0) {
      throw FormatError("base64 goes on after its padding");
    }
    bits = bits << 6 | static_cast<std::uint32_t>(value == kPadding ? 0 : value);
    if (++digits < 4) continue;
    if (pads > 2) throw FormatError("base64 has too much padding");
    write(3 - pads);
    bits = 0, digits = pads = 0;
  }
  if (digits != 0 && !prefix) throw FormatError("base64 ends in the middle of a group");
  bytes.resize(static_cast<std::size_t>(out - bytes.data()));
  return bytes;
}

}  // namespace tensortopo::detail
