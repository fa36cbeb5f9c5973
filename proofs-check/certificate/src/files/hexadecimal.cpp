// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/hexadecimal.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "mesh/power_of_two.hpp"

namespace certificate {

std::optional<mpq_class> hexadecimal(const std::string& text) {
  const std::size_t end = std::min(text.find('p'), text.size());
  if (!text.starts_with("0x") || end == 2) return std::nullopt;
  std::string digits = text.substr(2, end - 2);
  long exponent = 0;
  if (end < text.size()) {
    const char *first = text.data() + end + 1, *last = text.data() + text.size();
    if (last - first > 1 && *first == '+' && first[1] != '-') ++first;
    const auto read = std::from_chars(first, last, exponent);
    if (read.ec != std::errc() || read.ptr != last || exponent > 10000 || exponent < -10000)
      return std::nullopt;
  }
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    digits.erase(point, 1);
    exponent -= 4 * static_cast<long>(digits.size() - point);
  }
  mpz_class whole;
  if (digits.find_first_not_of("0123456789abcdef") != std::string::npos ||
      whole.set_str(digits, 16) != 0)
    return std::nullopt;
  return times_power_of_two(mpq_class(whole), exponent);
}

}  // namespace certificate
