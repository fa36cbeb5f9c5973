// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <tuple>

#include "analyze/persistence/graph_command.hpp"
#include "analyze/persistence/persistence_command.hpp"
#include "analyze/surface/surface_command.hpp"
#include "analyze/sweep/sweep_command.hpp"
#include "program/options/read_options.hpp"
#include "program/output/progress_bar.hpp"
#include "program/output/provenance_of.hpp"
#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/lower_extension.hpp"

namespace tensortopo {
namespace {

struct AnalyzeOptions {
  std::filesystem::path input, output, mesh, against, ridges, chart;
  std::string sweep;
  std::size_t most_levels = SweepOptions{}.most_levels, check_modes = 0;
  bool smooth = false, recover = false, persistence = false, graph = false;
  RidgeFilter ridge_filter;
  ReadOptions read;
  const CLI::App* app = nullptr;  ///< knows which options were given
};

/// Runs an analysis with progress, and prints its notes and its report.
/// @param run  from the progress callback to the report
/// @param notes_of  of a report: the file, and what its reader noted
template <class Run, class NotesOf>
auto report_of(const CommonOptions& common, const char* schema, const Run& run,
               const NotesOf& notes_of) {
  ProgressBar bar(!common.quiet);
  auto report = run(bar.callback());
  bar.erase();
  const auto& [file, notes] = notes_of(report);
  say_notes(file, notes, common.quiet);
  print_report(
      common, schema, [&] { return to_json(report); }, [&] { return to_text(report); }, true);
  return report;
}

constexpr auto kNotesOfInput = [](const auto& report) {
  return std::tie(report.input, report.notes);
};

ExitStatus sweep(const AnalyzeOptions& options, const CommonOptions& common) {
  SweepCommand command;
  command.input = options.input;
  command.read = options.read;
  command.picture = options.output;
  command.sweep.most_levels = options.most_levels;
  command.check_modes = options.check_modes;
  parse_sweep(options.sweep, command.sweep);
  const SweepReport report = report_of(
      common, "analyze-sweep",
      [&](const Progress& progress) { return run_sweep(command, progress); }, kNotesOfInput);
  return report.is_contradicted() ? ExitStatus::undecided : ExitStatus::done;
}

ExitStatus persistence(const AnalyzeOptions& options, const CommonOptions& common) {
  PersistenceCommand command;
  command.input = options.input;
  command.read = options.read;
  command.output = options.output;
  command.provenance = provenance_of(*options.app, common);
  command.picture = options.chart;
  report_of(
      common, "analyze-persistence",
      [&](const Progress& progress) { return run_persistence(command, progress); }, kNotesOfInput);
  return ExitStatus::done;
}

ExitStatus graph(const AnalyzeOptions& options, const CommonOptions& common) {
  GraphCommand command;
  command.input = options.input;
  command.read = options.read;
  command.output = options.output;
  command.provenance = provenance_of(*options.app, common);
  report_of(
      common, "analyze-graph",
      [&](const Progress& progress) { return run_graph(command, progress); }, kNotesOfInput);
  return ExitStatus::done;
}

ExitStatus surface(const AnalyzeOptions& options, const CommonOptions& common) {
  SurfaceCommand command;
  command.surface = options.input;
  command.mesh = options.mesh;
  command.against = options.against;
  command.output = options.output;
  command.provenance = provenance_of(*options.app, common);
  command.ridges = options.ridges;
  command.ridge_filter = options.ridge_filter;
  command.smooth = options.smooth;
  command.recover = options.recover;
  command.read = options.read;
  report_of(
      common, "analyze-surface",
      [&](const Progress& progress) { return run_surface_analysis(command, progress); },
      [&](const SurfaceAnalysis& analysis) { return std::tie(command.mesh, analysis.mesh_notes); });
  return ExitStatus::done;
}

ExitStatus analyze(const AnalyzeOptions& options, const CommonOptions& common) {
  const bool is_surface = lower_extension(options.input) == ".vtp";
  const bool has_sweep = !options.sweep.empty();
  const int kinds = int{has_sweep} + int{options.persistence} + int{options.graph};
  if (is_surface && kinds > 0)
    throw UsageError(options.input.string() +
                     ": --sweep, --persistence and --graph take a mesh, not a surface");
  if (kinds > 1) throw UsageError("--sweep, --persistence and --graph exclude each other");
  if (!is_surface && kinds == 0)
    throw UsageError(
        options.input.string() +
        ": a mesh needs --sweep A:B:N, --persistence or --graph (a surface is a .vtp)");
  const RidgeFilter& filter = options.ridge_filter;
  if (!is_surface &&
      (!options.mesh.empty() || !options.against.empty() || !options.ridges.empty() ||
       options.smooth || options.recover || filter.least_strength != 0 || filter.least_length != 0))
    throw UsageError(
        "--mesh, --against, --recover, --ridges (with --ridge-strength, --ridge-length) and "
        "--smooth are for surfaces (.vtp)");
  if (!has_sweep) refuse_given(*options.app, {"--check", "--levels"}, "goes with --sweep");
  if (!options.persistence) refuse_given(*options.app, {"--chart"}, "goes with --persistence");
  if (is_surface && options.mesh.empty())
    refuse_read_options(*options.app, "is about a mesh (--mesh)");
  if (options.persistence) return persistence(options, common);
  if (options.graph) return graph(options, common);
  return is_surface ? surface(options, common) : sweep(options, common);
}

}  // namespace

void add_analyze_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "analyze", "Topology against the mode of a field; shape and quality of surfaces");
  const auto options = std::make_shared<AnalyzeOptions>();
  options->app = &app;
  reads(common, app.add_option("INPUT", options->input, field_help() + "; or a surface (.vtp)"))
      ->required();
  app.add_option(
         "--sweep", options->sweep,
         "Of a mesh: all critical values of the mode above A and up to B, and the topology and "
         "area of the mode surfaces of N modes, evenly spaced")
      ->type_name("A:B:N");
  app.add_flag("--persistence", options->persistence,
               "Of a mesh: at which modes components, loops and voids of {mode >= m} and "
               "{mode <= m} and degenerate curves are born and die, and what relative noise they "
               "survive");
  app.add_flag("--graph", options->graph,
               "Of a mesh: the contour tree of the mode, the regions that the neutral surface "
               "bounds with the degenerate curves in them, and linking numbers of closed curves");
  app.add_option(
         "--levels", options->most_levels,
         "Extract a surface between each two critical values if this many are enough, else in "
         "the five widest ranges")
      ->type_name("N")
      ->check(whole_number())
      ->capture_default_str();
  app.add_option("--check", options->check_modes,
                 "With --sweep: extract and certify the surfaces of about N modes between and next "
                 "to critical values, and compare; exit status 1 if one contradicts the sweep")
      ->type_name("N")
      ->check(whole_number());
  reads(common,
        app.add_option("--mesh", options->mesh,
                       "Of a surface: the mesh that it was extracted from, for its curvature and "
                       "umbilics by the field's derivatives"))
      ->type_name("FILE");
  app.add_flag("--recover", options->recover,
               "Of a surface with --mesh: also the curvature of the smooth field, by derivatives "
               "recovered at the mesh's vertices; --ridges then goes by it");
  writes(common,
         app.add_option(
             "--ridges", options->ridges,
             "Of a surface with --mesh: write its ridges and valleys, along which a principal "
             "curvature is extremal in its direction (.vtp)"))
      ->type_name("FILE");
  app.add_option("--ridge-strength", options->ridge_filter.least_strength,
                 "Leave out ridges and valleys whose strength (of the array of this name, the mean "
                 "along the line) is less, in 1 / length^3")
      ->type_name("S");
  app.add_option("--ridge-length", options->ridge_filter.least_length,
                 "Leave out ridges and valleys that are shorter")
      ->type_name("L");
  app.add_flag("--smooth", options->smooth,
               "Of a surface: also the curvature that polynomials fitted to its vertices have");
  reads(common, app.add_option("--against", options->against,
                               "Of a surface: sampled distances to another one (.vtp), both ways"))
      ->type_name("FILE");
  writes(common, app.add_option("-o,--output", options->output,
                                "The sweep's picture (.png), the pairs of --persistence or the "
                                "tree of --graph (.vtp), or the "
                                "surface with its curvatures (.vtp)"))
      ->type_name("FILE");
  writes(common, app.add_option("--chart", options->chart,
                                "With --persistence: diagrams, barcodes and Betti numbers (.png)"))
      ->type_name("FILE");
  add_read_options(app, common, options->read);
  add_common_options(app, common);
  app.callback([options, &common, &action] {
    action = [options, &common] { return analyze(*options, common); };
  });
}

}  // namespace tensortopo
