// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdint>
#include <string>
#include <vector>

namespace tensortopo {

/// What every subcommand understands.
struct CommonOptions {
  bool json = false;
  bool quiet = false;
  int threads = 0;  ///< 0: all
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

inline void add_common_options(CLI::App& app, CommonOptions& common) {
  app.add_flag("--json", common.json, "Print one JSON object on standard output, nothing else");
  app.add_flag("--quiet", common.quiet, "No progress and no notes on standard error");
  app.add_option("--threads", common.threads, "Threads to use (default: all)")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
}

}  // namespace tensortopo
