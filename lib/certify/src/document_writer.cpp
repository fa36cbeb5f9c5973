// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "document_writer.hpp"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

namespace tensortopo::detail {

void DocumentWriter::unsigned_number(std::uint64_t x) {
  separate();
  if (!is_text_) return head(0, x);
  std::array<char, 20> digits;
  bytes_.append(digits.data(), std::to_chars(digits.begin(), digits.end(), x).ptr);
}

void DocumentWriter::negative_number(std::int64_t x) {
  separate();
  if (!is_text_) return head(0x20, static_cast<std::uint64_t>(-1 - x));
  std::array<char, 20> digits;
  bytes_.append(digits.data(), std::to_chars(digits.begin(), digits.end(), x).ptr);
}

void DocumentWriter::head(std::uint8_t major, std::uint64_t x) {
  const auto byte = [&](std::uint64_t b) { bytes_ += static_cast<char>(b & 0xFF); };
  if (x < 24) return byte(major | x);
  const int size = x <= 0xFF ? 0 : x <= 0xFFFF ? 1 : x <= 0xFFFFFFFF ? 2 : 3;
  byte(major | static_cast<unsigned>(24 + size));
  for (int shift = 8 << size; shift > 0;) byte(x >> (shift -= 8));
}

void DocumentWriter::key(std::string_view name) {
  value(nlohmann::ordered_json(name));
  if (!is_text_) return;
  bytes_ += ':';
  is_first_ = true;
}

void DocumentWriter::value(const nlohmann::ordered_json& json) {
  separate();
  if (is_text_)
    bytes_ += json.dump();
  else
    nlohmann::ordered_json::to_cbor(json, bytes_);
}

}  // namespace tensortopo::detail
