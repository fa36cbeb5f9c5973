// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {

/// What every subcommand understands.
struct CommonOptions {
  bool json = false;
  bool quiet = false;
  int threads = 0;  ///< 0: all
  const CLI::App* chosen = nullptr;  ///< the subcommand
  std::vector<CLI::Option*> reads, writes;  ///< of all subcommands: options that name files
};

/// An option that names files to read, or to write: see `require_distinct_files`.
inline CLI::Option* reads(CommonOptions& common, CLI::Option* option) {
  return common.reads.emplace_back(option);
}
inline CLI::Option* writes(CommonOptions& common, CLI::Option* option) {
  return common.writes.emplace_back(option);
}

/// Of options without sign: CLI11 would wrap others around.
inline CLI::Validator whole_number() {
  return {[](const std::string& text) -> std::string {
            std::uint64_t value = 0;
            const char* const end = text.data() + text.size();
            const auto [last, error] = std::from_chars(text.data(), end, value);
            return error == std::errc() && last == end ? "" : "'" + text + "' is no whole number "
                                                              "from 0 to 18446744073709551615";
          },
          "WHOLE"};
}

/// A finite number in [least, most]; CLI11's own checks let pass what is not a number.
inline CLI::Validator number_from(double least, double most, const std::string& what) {
  return {[=](const std::string& text) -> std::string {
            double value = std::nan("");
            const bool is_number = CLI::detail::lexical_cast(text, value);
            return is_number && std::isfinite(value) && value >= least && value <= most
                       ? ""
                       : "'" + text + "' is no " + what;
          },
          ""};
}
inline CLI::Validator positive_number() {
  return number_from(std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(),
                     "positive number");
}
inline CLI::Validator number_not_negative() {
  return number_from(0, std::numeric_limits<double>::max(), "number from 0 on");
}

/// Throws UsageError if one of these options was given: here they would be ignored.
inline void refuse_given(const CLI::App& app, std::initializer_list<const char*> options,
                         const std::string& why) {
  for (const char* option : options)
    if (app.count(option) > 0) throw UsageError(std::string(option) + ": " + why);
}

inline void add_common_options(CLI::App& app, CommonOptions& common) {
  app.add_flag("--json", common.json, "Print one JSON object on standard output, nothing else");
  app.add_flag("--quiet", common.quiet, "No progress and no notes; and no summary where the result is a file");
  app.add_option("--threads", common.threads, "Threads to use (default: all)")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
}

}  // namespace tensortopo
