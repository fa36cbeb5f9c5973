// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/bench_command.hpp"
#include "bench/page/measurements.hpp"
#include "bench/scaling.hpp"
#include "program/options/mode_option.hpp"
#include "program/options/read_options.hpp"
#include "program/output/progress_bar.hpp"
#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"
#include "require_folder.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/write_text.hpp"

namespace tensortopo {
namespace {

struct BenchOptions {
  BenchCommand command;
  std::vector<std::string> modes, only;
  std::string scaling;
  std::filesystem::path curves, chart, report;
  std::vector<std::filesystem::path> inputs;
  std::size_t largest = ScalingCommand().largest;
  double budget = MeasurementsCommand().budget;
  const CLI::App* app = nullptr;  ///< knows which options were given
};

const std::map<std::string, ScalingOver>& scalings() {
  static const std::map<std::string, ScalingOver> known{{"size", ScalingOver::size},
                                                        {"mode", ScalingOver::mode},
                                                        {"threads", ScalingOver::threads},
                                                        {"modes", ScalingOver::modes}};
  return known;
}

std::vector<ModeValue> surface_modes(const BenchOptions& options) {
  const auto modes = parse_modes(options.modes);
  for (const ModeValue& mode : modes) {
    if (is_degenerate(mode)) {
      throw UsageError("--mode " + mode.text() + ": VTK has no counterpart to degenerate curves");
    }
  }
  return modes;
}

/// The smallest field of examples/data, beside the program's sources or where it is installed.
std::filesystem::path bundled_field() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  std::filesystem::path smallest;
  std::uintmax_t least = 0;
  for (auto folder = program.parent_path(); smallest.empty() && folder != folder.parent_path();
       folder = folder.parent_path())
    for (const char* data : {"examples/data", "share/tensortopo/data"})
      for (const auto& file : std::filesystem::directory_iterator(folder / data, error)) {
        const auto size = file.file_size(error);
        if (error || lower_extension(file.path()) != ".vtu") continue;
        if (smallest.empty() || size < least) smallest = file.path(), least = size;
      }
  if (smallest.empty())
    throw UsageError("--input is required: no folder examples/data is beside the program");
  return smallest;
}

/// Throws UsageError or IoError for a chart that could not be written, before anything is timed.
void require_picture(const std::filesystem::path& file) {
  if (file.empty()) return;
  if (lower_extension(file) != ".png")
    throw UsageError(file.string() + ": the name must end in .png");
  require_folder(file);
}

/// Empty if none was given. Throws UsageError for several.
std::filesystem::path only_input(const BenchOptions& options) {
  if (options.inputs.size() > 1) throw UsageError("--input: several go with --report only");
  return options.inputs.empty() ? std::filesystem::path() : options.inputs.front();
}

ExitStatus report(const BenchOptions& options, const CommonOptions& common) {
  refuse_given(*options.app, {"--curves", "--scaling", "--chart", "--largest", "--json"},
               "has no effect on --report");
  require_folder(options.report);
  MeasurementsCommand command;
  command.inputs = options.inputs;
  if (command.inputs.empty()) command.inputs = {bundled_field()};
  command.read = options.command.read;
  command.read_words = given_read_options(*options.app);
  for (const std::string& name : options.only)
    if (name != "certified" && name != "none") command.only.push_back(name);
  command.modes = surface_modes(options);
  if (command.modes.empty())
    for (const char* mode : {"0", "1/10", "1/2", "9/10", "99/100"})
      command.modes.push_back(ModeValue::parse(mode));
  for (ModeValue& mode : command.modes)
    if (mode.sign() < 0) mode = mode.opposite();
  command.repeat = options.command.repeat;
  command.all = options.command.all;
  command.budget = options.budget;
  ProgressBar bar(!common.quiet);
  const std::string page = measurements_page(command, bar.callback());
  bar.erase();
  write_text(options.report, page);
  if (!common.quiet) print(options.report.string() + ": written\n");
  return ExitStatus::done;
}

ExitStatus scaling(const BenchOptions& options, const CommonOptions& common) {
  ScalingCommand command;
  command.over = scalings().at(options.scaling);
  refuse_given(*options.app, {"--only", "--all", "--curves", "--budget"},
               "has no effect on --scaling");
  if (command.over == ScalingOver::size) {
    const char* const why = "has no effect on --scaling size, which makes its meshes";
    refuse_given(*options.app, {"--input"}, why);
    refuse_read_options(*options.app, why);
  } else {
    refuse_given(*options.app, {"--largest"}, "goes with --scaling size");
  }
  require_picture(options.chart);
  command.input = only_input(options);
  command.read = options.command.read;
  command.modes = surface_modes(options);
  command.largest = options.largest;
  command.repeat = options.command.repeat;
  ProgressBar bar(!common.quiet);
  const ScalingReport report = run_scaling(command, bar.callback());
  if (!options.chart.empty()) write_text(options.chart, scaling_chart(report));
  bar.erase();
  say_notes(command.input, report.notes, common.quiet);
  print_report(
      common, "bench-scaling", [&] { return to_json(report); }, [&] { return to_text(report); },
      true);
  return ExitStatus::done;
}

ExitStatus bench(const BenchOptions& options, const CommonOptions& common) {
  if (!options.report.empty()) return report(options, common);
  if (!options.scaling.empty()) return scaling(options, common);
  refuse_given(*options.app, {"--chart", "--largest"}, "only with --scaling");
  refuse_given(*options.app, {"--budget"}, "only with --report");
  require_picture(options.curves);
  BenchCommand command = options.command;
  command.input = only_input(options);
  command.modes = surface_modes(options);
  if (command.input.empty()) {
    command.input = bundled_field();
    if (command.modes.empty()) command.modes = {ModeValue::parse("1/2")};
  }
  command.modes = modes_to_extract(command.modes, false);
  if (!options.only.empty()) command.only = options.only;
  command.curves = !options.curves.empty();
  ProgressBar bar(!common.quiet);
  const BenchReport report = run_bench(command, bar.callback());
  if (command.curves)
    write_text(options.curves, curves_chart(report.curves, command.input.filename().string()));
  bar.erase();
  say_notes(command.input, report.notes, common.quiet);
  print_report(
      common, "bench", [&] { return to_json(report); }, [&] { return to_text(report); }, true);
  return ExitStatus::done;
}

}  // namespace

void add_bench_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "bench", "Time extraction against VTK's contours of the vertex modes and other methods");
  const auto options = std::make_shared<BenchOptions>();
  options->app = &app;
  BenchCommand& command = options->command;
  reads(common, app.add_option("--input", options->inputs,
                               "Tetrahedral mesh with tensors (default: the smallest of "
                               "examples/data, and without --mode then 1/2); with --report "
                               "repeatable"))
      ->type_name("FILE")
      ->allow_extra_args(false);
  writes(common,
         app.add_option("--report", options->report,
                        "Write a page of measurements: times, certificates, curves, for each "
                        "--input and --mode (default: 0, 1/10, 1/2, 9/10, 99/100); with --all "
                        "or --only other methods at equal error as well"))
      ->type_name("OUT.md");
  app.add_option("--budget", options->budget,
                 "Seconds of --report: what does not fit is repeated less often, or left out")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  add_mode_option(app, options->modes)
      ->description("Mode M; surfaces of M and -M are timed; repeatable")
      ->required(false);
  app.add_option("--repeat", command.repeat, "Timings of each, interleaved; medians are reported")
      ->type_name("N")
      ->check(CLI::Range(5, 1000))
      ->capture_default_str();
  app.add_option("--only", options->only,
                 "Of the slow comparisons only this one; repeatable (default: certified; or none)")
      ->type_name("NAME")
      ->check(CLI::IsMember([] {
        auto names = BenchCommand::comparisons();
        names.push_back("none");
        return names;
      }()))
      ->allow_extra_args(false);
  app.add_flag("--all", command.all, "All comparisons, whatever the size of the mesh");
  writes(common,
         app.add_option("--curves", options->curves, "Also time against error, and a chart of it"))
      ->type_name("P.png");
  std::vector<std::string> names;
  for (const auto& [name, over] : scalings()) names.push_back(name);
  app.add_option(
         "--scaling", options->scaling,
         "Instead: time over the mesh's size (no input), the mode, threads, or number of modes")
      ->check(CLI::IsMember(names));
  app.add_option("--largest", options->largest, "Tetrahedra, of --scaling size")
      ->type_name("N")
      ->check(whole_number())
      ->capture_default_str();
  add_read_options(app, common, command.read);
  writes(common, app.add_option("--chart", options->chart, "Of --scaling"))->type_name("P.png");
  add_common_options(app, common);
  app.callback([options, &common, &action] {
    action = [options, &common] { return bench(*options, common); };
  });
}

}  // namespace tensortopo
