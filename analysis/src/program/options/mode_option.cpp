// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/options/mode_option.hpp"

#include <stdexcept>

#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/mode_range.hpp"
#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {

CLI::Option* add_mode_option(CLI::App& app, std::vector<std::string>& modes) {
  return app
      .add_option("--mode", modes,
                  "Mode in [-1, 1], a decimal or a fraction, taken exactly, or A:B:N for N modes "
                  "from A to B; repeatable")
      ->type_name("M")
      ->required()
      ->allow_extra_args(false);
}

std::vector<ModeValue> parse_modes(const std::vector<std::string>& modes) {
  std::vector<ModeValue> values;
  for (const std::string& text : modes) {
    if (text.find(':') != std::string::npos) {
      constexpr std::size_t kMost = 10000;
      const auto range = parse_mode_range("--mode", text, kMost);
      values.insert(values.end(), range.begin(), range.end());
      continue;
    }
    try {
      values.push_back(parse_mode(text));
    } catch (const std::invalid_argument& problem) {
      throw UsageError("--mode " + text + ": " + problem.what());
    }
  }
  return values;
}

}  // namespace tensortopo
