// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include "conformance/conformance_command.hpp"
#include "conformance/suite.hpp"
#include "program/options/mode_option.hpp"
#include "program/options/read_options.hpp"
#include "program/output/progress_bar.hpp"
#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/surface_formats.hpp"

namespace tensortopo {
namespace {

struct ConformanceOptions {
  ConformanceCommand command;
  std::vector<std::string> modes;
  std::filesystem::path suite;
  const CLI::App* app = nullptr;  ///< knows which options were given
};

ExitStatus suite(const ConformanceOptions& options, const CommonOptions& common) {
  const char* const why = "has no effect on --suite";
  refuse_given(*options.app,
               {"--surface", "--input", "--mode", "--truth", "--merge", "--resolution"}, why);
  refuse_read_options(*options.app, why);
  const auto entries = read_suite(options.suite);
  ProgressBar bar(!common.quiet);
  const SuiteReport report = run_suite(entries, bar.callback());
  bar.erase();
  print_report(
      common, "conformance-suite", [&] { return to_json(report); }, [&] { return to_markdown(report); }, true);
  return ExitStatus::done;
}

ExitStatus conformance(const ConformanceOptions& options, const CommonOptions& common) {
  if (!options.suite.empty()) return suite(options, common);
  ConformanceCommand command = options.command;
  const auto modes = parse_modes(options.modes);
  if (command.surface.empty() || command.input.empty() || modes.size() != 1)
    throw UsageError("conformance needs --surface, --input and one --mode, or --suite");
  command.mode = modes.front();
  ProgressBar bar(!common.quiet);
  const ConformanceReport report = run_conformance(command, bar.callback());
  bar.erase();
  say_notes(command.input, report.notes, common.quiet);
  print_report(
      common, "conformance", [&] { return to_json(report); }, [&] { return to_text(report); }, true);
  return report.score.conforms() ? ExitStatus::done : ExitStatus::undecided;
}

}  // namespace

void add_conformance_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "conformance", "Score another program's mode surface against certified truth");
  const auto options = std::make_shared<ConformanceOptions>();
  ConformanceCommand& command = options->command;
  options->app = &app;
  app.add_option("--surface", command.surface, "Triangles to score: " + surface_extensions())
      ->type_name("FILE");
  app.add_option("--input", command.input, "Tetrahedral mesh with tensors that they were made from")
      ->type_name("MESH");
  add_mode_option(app, options->modes)
      ->required(false)
      ->description("Mode of the surface, taken exactly");
  app.add_option("--truth", command.truth,
                 "Truth file of `generate`; must agree with what is certified now")
      ->type_name("FILE");
  add_read_options(app, common, command.read);
  app.add_option("--merge", command.merge,
                 "Merge points in boxes of this size (default: equal ones only)")
      ->type_name("EPS")
      ->check(number_not_negative());
  app.add_option("--resolution", command.resolution,
                 "Of the certified surface: samples per radian of turning")
      ->type_name("R")
      ->check(number_from(1e-9, kLargestResolution, "number from 1e-9 to 1000"))
      ->capture_default_str();
  app.add_option("--suite", options->suite,
                 "Instead: score VTK's contours over a list of generated fields; prints Markdown")
      ->type_name("LIST.json");
  add_common_options(app, common);
  app.callback([options, &common, &action] {
    action = [options, &common] { return conformance(*options, common); };
  });
}

}  // namespace tensortopo
