// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/to_base64.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tensortopo::detail {
namespace {

constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The two digits of 12 bits.
constexpr std::array<std::array<char, 2>, 4096> make_pairs() {
  std::array<std::array<char, 2>, 4096> pairs{};
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {digits[i >> 6], digits[i & 63]};
  return pairs;
}

constexpr auto kPairs = make_pairs();

/// Whole groups of three bytes.
void encode(std::span<const std::byte> bytes, char* out) {
  for (std::size_t i = 0; i + 3 <= bytes.size(); i += 3) {
    const auto bits = std::to_integer<std::uint32_t>(bytes[i]) << 16 |
                      std::to_integer<std::uint32_t>(bytes[i + 1]) << 8 |
                      std::to_integer<std::uint32_t>(bytes[i + 2]);
    const auto &first = kPairs[bits >> 12], &second = kPairs[bits & 0xfff];
    *out++ = first[0], *out++ = first[1], *out++ = second[0], *out++ = second[1];
  }
}

}  // namespace

void append_base64(std::span<const std::byte> bytes, std::string& text) {
  const std::size_t groups = bytes.size() / 3, rest = bytes.size() % 3, begin = text.size();
  text.resize(begin + 4 * (groups + (rest > 0 ? 1 : 0)));
  char* const out = text.data() + begin;
  constexpr std::size_t grain = 1 << 15;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, groups, grain), [&](const auto& range) {
    encode(bytes.subspan(3 * range.begin(), 3 * range.size()), out + 4 * range.begin());
  });
  if (rest == 0) return;
  std::array<std::byte, 3> last{};
  for (std::size_t i = 0; i < rest; ++i) last[i] = bytes[3 * groups + i];
  encode(last, out + 4 * groups);
  for (std::size_t i = rest; i < 3; ++i) out[4 * groups + i + 1] = '=';
}

}  // namespace tensortopo::detail
