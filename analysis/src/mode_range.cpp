// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/analysis/mode_range.hpp"

#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {

std::vector<ModeValue> parse_mode_range(const std::string& option, std::string_view text,
                                        std::size_t most) {
  const auto fail = [&](const std::string& why) {
    throw UsageError(option + " " + std::string(text) + ": " + why);
  };
  const std::size_t one = text.find(':'), two = text.find(':', one + 1);
  if (one == std::string_view::npos || two == std::string_view::npos) fail("must be A:B:N");
  const std::string_view count = text.substr(two + 1);
  std::size_t number = 0;
  const auto read = std::from_chars(count.data(), count.data() + count.size(), number);
  if (read.ec != std::errc() || read.ptr != count.data() + count.size() || number < 2 ||
      number > most)
    fail(fmt::format("N must be a number of modes, 2 to {}", most));
  std::vector<ModeValue> modes;
  try {
    const auto from = to_scalar<Rational>(parse_mode(text.substr(0, one)));
    const auto to = to_scalar<Rational>(parse_mode(text.substr(one + 1, two - one - 1)));
    for (std::size_t i = 0; i < number; ++i) {
      const Rational share =
          Rational(static_cast<long>(i)) / Rational(static_cast<long>(number - 1));
      modes.push_back(ModeValue::parse(Rational(from + share * (to - from)).str()));
    }
  } catch (const std::invalid_argument& problem) {
    fail(problem.what());
  }
  return modes;
}

}  // namespace tensortopo
