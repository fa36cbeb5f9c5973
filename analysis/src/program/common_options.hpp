// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace tensortopo {

/// What every subcommand understands.
struct CommonOptions {
  bool json = false;
  bool quiet = false;
  int threads = 0;  ///< 0: all
};

inline void add_common_options(CLI::App& app, CommonOptions& common) {
  app.add_flag("--json", common.json, "Print one JSON object on standard output, nothing else");
  app.add_flag("--quiet", common.quiet, "No progress and no notes on standard error");
  app.add_option("--threads", common.threads, "Threads to use (default: all)")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
}

}  // namespace tensortopo
