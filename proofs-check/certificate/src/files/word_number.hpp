// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace certificate {

/// The same number; of integers beyond 2^53, which doubles do not all hold, there is none.
template <class Stored>
double in_double(Stored x) {
  if constexpr (std::is_integral_v<Stored> && sizeof(Stored) == 8) {
    constexpr auto kMost = Stored{1} << 53;
    if (x > kMost || (std::is_signed_v<Stored> && x < -kMost)) return HUGE_VAL;
  }
  return static_cast<double>(x);
}

/// The number that a whole word spells, as a type stores it: of integers digits, perhaps after a
/// minus, and of others a decimal number, as other readers take no more for one. Nothing if it is
/// none, or not within the type's range.
template <class Stored>
std::optional<double> number_of_word(std::string_view word) {
  if constexpr (std::is_integral_v<Stored>) {
    Stored x{};
    const char* const last = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), last, x);
    if (error != std::errc() || end != last) return std::nullopt;
    return in_double(x);
  } else {
    const std::string text(word);
    if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos)
      return std::nullopt;
    char* end = nullptr;
    const double x = sizeof(Stored) == 4 ? static_cast<double>(std::strtof(text.c_str(), &end))
                                         : std::strtod(text.c_str(), &end);
    if (end != text.c_str() + text.size() || !std::isfinite(x)) return std::nullopt;
    return x;
  }
}

}  // namespace certificate
