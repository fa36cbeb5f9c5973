// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include "bench/bench_command.hpp"
#include "program/mode_option.hpp"
#include "program/progress_bar.hpp"
#include "program/report_output.hpp"
#include "program/subcommands.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {
namespace {

struct Options {
  BenchCommand command;
  std::vector<std::string> modes, only;
};

ExitStatus bench(const Options& options, const CommonOptions& common) {
  BenchCommand command = options.command;
  command.modes = modes_to_extract(parse_modes(options.modes), false);
  for (const ModeValue& mode : command.modes) {
    if (is_degenerate(mode)) {
      throw UsageError("--mode " + mode.text() + ": VTK has no counterpart to degenerate curves");
    }
  }
  if (!options.only.empty()) command.only = options.only;
  ProgressBar bar(!common.quiet);
  const BenchReport report = run_bench(command, bar.callback());
  bar.erase();
  print(common.json ? to_json(report) + '\n' : to_text(report));
  return ExitStatus::done;
}

}  // namespace

void add_bench_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "bench", "Time extraction against VTK's contours of the vertex modes and other methods");
  const auto options = std::make_shared<Options>();
  BenchCommand& command = options->command;
  app.add_option("--input", command.input, "Tetrahedral mesh with tensors")
      ->type_name("FILE")
      ->required();
  add_mode_option(app, options->modes)
      ->description("Mode M; surfaces of M and -M are timed; repeatable");
  app.add_option("--repeat", command.repeat, "Timings of each, interleaved; medians are reported")
      ->type_name("N")
      ->check(CLI::Range(5, 1000))
      ->capture_default_str();
  app.add_option("--only", options->only,
                 "Of the slow comparisons only this one; repeatable (default: all on small meshes)")
      ->type_name("NAME")
      ->check(CLI::IsMember([] {
        auto names = BenchCommand::comparisons();
        names.push_back("none");
        return names;
      }()))
      ->allow_extra_args(false);
  app.add_flag("--all", command.all, "All comparisons, whatever the size of the mesh");
  add_common_options(app, common);
  app.callback([options, &common, &action] {
    action = [options, &common] { return bench(*options, common); };
  });
}

}  // namespace tensortopo
