// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include "analyze/sweep/sweep_command.hpp"
#include "program/options/mode_option.hpp"
#include "program/options/read_options.hpp"
#include "program/output/progress_bar.hpp"
#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"
#include "report/report_command.hpp"

namespace tensortopo {
namespace {

struct ReportOptions {
  ReportCommand command;
  std::vector<std::string> modes;
  std::string sweep = "-9/10:9/10:2";
  bool no_sweep = false, no_curves = false, no_certificate = false;
};

ExitStatus report(const ReportOptions& options, const CommonOptions& common) {
  ReportCommand command = options.command;
  command.modes = parse_modes(options.modes);
  command.curves = !options.no_curves;
  command.certify = !options.no_certificate;
  if (!options.no_sweep) parse_sweep(options.sweep, command.sweep.emplace());
  ProgressBar bar(!common.quiet);
  const ReportSummary summary = run_report(command, bar.callback());
  bar.erase();
  print_report(
      common, "report", [&] { return to_json(summary); }, [&] { return to_text(summary); });
  const bool is_open = summary.verdict == "refuted" || summary.verdict == "undecided";
  return is_open ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace

void add_report_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "report", "One page for people: surfaces in 3D, topology, the checker's verdict");
  const auto options = std::make_shared<ReportOptions>();
  ReportCommand& command = options->command;
  reads(common, app.add_option("INPUT", command.input,
                               field_help()))
      ->required();
  writes(common, app.add_option("-o,--output", command.output,
                                "The page, which needs nothing else: no file, no network"))
      ->type_name("FILE.html")
      ->required();
  add_mode_option(app, options->modes);
  app.add_flag("--generalized", command.generalized, "With each mode M, also -M");
  app.add_option("--resolution", command.resolution,
                 "Samples per radian of turning of an eigenvector; at most 1000")
      ->type_name("R")
      ->check(number_from(1e-3, 1000, "number from 0.001 to 1000"))
      ->capture_default_str();
  auto* sweep = app.add_option("--sweep", options->sweep,
                               "The diagram: modes from A to B, with N levels extracted at least")
                    ->type_name("A:B:N")
                    ->capture_default_str();
  app.add_option("--uncertainty", command.uncertainty,
                 "Show what is the same for all fields whose deviators differ by at most E: in "
                 "units of the tensor, E%, or array:NAME (see extract); what is not is faded")
      ->type_name("E");
  app.add_flag("--no-sweep", options->no_sweep, "No diagram")->excludes(sweep);
  app.add_flag("--no-curves", options->no_curves, "No degenerate curves");
  app.add_flag("--no-certificate", options->no_certificate, "No certificate, no verdict");
  add_read_options(app, common, command.read);
  add_common_options(app, common);
  app.callback([options, &common, &action] {
    action = [options, &common] { return report(*options, common); };
  });
}

}  // namespace tensortopo
