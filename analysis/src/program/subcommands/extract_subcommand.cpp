// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "contours/vtk_contours.hpp"
#include "program/options/invariant_option.hpp"
#include "program/options/memory_option.hpp"
#include "program/options/mode_option.hpp"
#include "program/options/read_options.hpp"
#include "program/output/progress_bar.hpp"
#include "program/output/provenance_of.hpp"
#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/baseline.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/field_steps.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/surface_formats.hpp"

namespace tensortopo {
namespace {

struct ExtractCommandOptions {
  ExtractCommand command;
  std::vector<std::string> modes;
  std::string memory;
  std::string method = "bisection";
  BaselineOptions baseline;
  InvariantOption invariant;
  const CLI::App* app = nullptr;  ///< knows which options were given
};

/// Options that do nothing here are no usage.
void require_effect(const ExtractCommandOptions& options) {
  const auto refuse = [&](const char* option, bool has_effect, const char* what) {
    if (!has_effect && options.app->count(option) > 0)
      throw UsageError(std::string(option) + ": " + what);
  };
  const bool is_baseline = options.method != "bisection" && options.method != "manifold";
  refuse("--patch-samples", options.method == "a-patches", "only with --method a-patches");
  refuse("--flatness", options.method == "hybrid", "only with --method hybrid");
  refuse("--resolution", !is_baseline, "has an effect on --method bisection and manifold only");
  refuse("--all-samples", !is_baseline, "has an effect on --method bisection and manifold only");
  refuse("--uncertainty", !options.command.uncertainty.empty(), "needs a number");
  refuse("--pieces", !is_baseline, "has an effect on --method bisection and manifold only");
  refuse("--pieces", options.app->count("--max-error") == 0, "does not go with --max-error");
  refuse("--subdivide", is_baseline, "has no effect on --method bisection or manifold");
}

/// With `--invariant`, `--pieces` is the old name of `--edge-parts`.
InvariantOption invariant_with_old_names(const ExtractCommandOptions& options) {
  InvariantOption invariant = options.invariant;
  if (options.app->count("--pieces") == 0) return invariant;
  if (options.app->count("--edge-parts") > 0 || options.command.pieces > 256)
    throw UsageError("--pieces: with --invariant the old name of --edge-parts, from 1 to 256");
  invariant.pieces = options.command.pieces;
  return invariant;
}

/// Nothing for our own methods.
Method other_method(const ExtractCommandOptions& options) {
  static const std::map<std::string, Baseline> baselines{{"marching", Baseline::marching},
                                                         {"a-patches", Baseline::a_patches},
                                                         {"hybrid", Baseline::hybrid}};
  static const std::map<std::string, VtkFilter> filters{
      {"vtk-contour-grid", VtkFilter::contour_grid},
      {"vtk-contour-3d-linear-grid", VtkFilter::contour_3d_linear_grid}};
  if (const auto found = baselines.find(options.method); found != baselines.end())
    return [method = found->second, how = options.baseline](const auto& mesh, const auto& mode) {
      return baseline_surface(method, mesh, mode, how);
    };
  if (const auto found = filters.find(options.method); found != filters.end())
    return [filter = found->second](const auto& mesh, const auto& mode) {
      return vtk_contour(mesh, mode, filter);
    };
  return nullptr;
}

/// Says of surfaces that are nearly everywhere that the mesh may be too coarse for the field.
void say_crowded(const ExtractReport& report) {
  constexpr std::size_t kFew = 1000;
  for (const SurfaceReport& surface : report.surfaces)
    if (report.tetrahedra > kFew && 2 * surface.statistics.tets_crossed > report.tetrahedra)
      std::cerr << "tensortopo: " << report.input.string() << ": mode " << short_text(surface.mode)
                << ": the surface meets "
                << 100 * surface.statistics.tets_crossed / report.tetrahedra
                << " % of the tetrahedra: the field is noise at this mesh's size, or the mesh too "
                   "coarse for it\n";
}

using Print = std::function<void(const ExtractReport& report)>;

ExitStatus extract_one(const ExtractCommandOptions& options, const CommonOptions& common,
                       const Print& print_one) {
  ExtractCommand command = options.command;
  command.provenance = provenance_of(*options.app, common);
  if (!options.invariant.invariant.empty())
    return extract_invariant(invariant_with_old_names(options), command, common);
  if (options.modes.empty()) throw UsageError("--mode or --invariant is required");
  require_effect(options);
  command.modes = parse_modes(options.modes);
  if (options.app->count("--memory") > 0) command.memory = parse_memory(options.memory);
  if (options.method == "manifold") command.meshing = MeshingMethod::manifold;
  command.other = other_method(options);
  command.only_neutral = options.method == "hybrid";

  ProgressBar bar(!common.quiet);
  const ExtractReport report = run_extract(command, bar.callback());
  bar.erase();
  say_notes(report.input, report.notes, common.quiet);
  const std::string unresolved = unresolved_line(report);
  if (!unresolved.empty()) {
    const std::string advice = common.quiet ? "" : unresolved_advice(report);
    std::cerr << "tensortopo: " << report.input.string() << ": " << unresolved
              << (report.written ? "" : "; nothing written") << (advice.empty() ? "" : "; ")
              << advice << '\n';
  }
  const std::vector<std::string> doubtful = doubtful_lines(report);
  for (const std::string& line : doubtful)
    if (!common.quiet || command.strict)
      std::cerr << "tensortopo: " << report.input.string() << ": " << line
                << (report.written ? "" : "; nothing written") << '\n';
  print_one(report);
  if (!common.quiet) say_crowded(report);
  bool is_farther = false;
  for (const SurfaceReport& surface : report.surfaces) {
    if (!surface.first_farther) continue;
    is_farther = true;
    if (!common.quiet || command.strict)
      std::cerr << "tensortopo: " << report.output.string() << ": mode " << short_text(surface.mode)
                << ": in " << counted_tets(surface.tets_farther) << " (the first is cell "
                << *surface.first_farther
                << ") the distance to the level is not proved to be below --max-error, as more "
                   "samples did not help, or would be too many or below rounding; "
                << std::floor(1000 * surface.area_within) / 10 << " % of the area is within it"
                << (report.written ? "" : "; nothing written") << '\n';
  }
  if (is_farther) return ExitStatus::undecided;
  if (say_undecided(report.certificate, common.quiet)) return ExitStatus::undecided;
  return command.strict && !report.written ? ExitStatus::undecided : ExitStatus::done;
}

/// One output for each step of the input, all of them or none.
ExitStatus extract_series(const ExtractCommandOptions& options, const CommonOptions& common) {
  const std::string pattern = options.command.output.string();
  if (!options.command.certificate.empty())
    throw UsageError("--certify: a certificate is about one field; convert a step, and certify it");
  if (!options.invariant.invariant.empty())
    throw UsageError("--invariant: is extracted of one step; choose it with --step");
  if (options.command.read.step) throw UsageError("--step: -o with {step} takes all steps");
  const std::vector<std::string> steps = field_steps(options.command.input);
  const std::size_t width = std::to_string(steps.size()).size();
  FileGroup files;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::string text;  // said when the files are there
  ExitStatus status = ExitStatus::done;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::string number = std::to_string(i + 1), name = pattern;
    number.insert(0, width - number.size(), '0');
    for (auto at = name.find(kStep); at != std::string::npos; at = name.find(kStep))
      name.replace(at, kStep.size(), number);
    ExtractCommandOptions one = options;
    one.command.output = name;
    one.command.read.step = i + 1;
    const ExitStatus each = extract_one(one, common, [&](const ExtractReport& report) {
      if (common.json) {
        auto json = nlohmann::ordered_json::parse(to_json(report));
        for (const char* said : {"schema", "version", "options"}) json.erase(said);
        list.push_back({{"step", i + 1}, {"text", steps[i]}, {"report", std::move(json)}});
      } else if (!common.quiet) {
        text += to_text(report);
      }
    });
    if (each != ExitStatus::done) status = each;
  }
  if (common.json)
    print(
        with_provenance(nlohmann::ordered_json{{"steps", list}}.dump(), common, "extract-series"));
  files.commit();
  if (!text.empty()) print(text);
  return status;
}

ExitStatus extract(const ExtractCommandOptions& options, const CommonOptions& common) {
  if (options.command.output.string().find(kStep) != std::string::npos)
    return extract_series(options, common);
  return extract_one(options, common, [&](const ExtractReport& report) {
    print_report(
        common, "extract", [&] { return to_json(report); }, [&] { return to_text(report); });
  });
}

}  // namespace

void add_extract_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "extract", "Extract mode surfaces and degenerate curves (modes 1 and -1) of a tensor field");
  const auto options = std::make_shared<ExtractCommandOptions>();
  ExtractCommand& command = options->command;
  options->app = &app;
  reads(common, app.add_option("INPUT", command.input, field_help()))->required();
  writes(common, app.add_option("-o,--output", command.output,
                                "Surfaces: " + surface_extensions() +
                                    " (.vtp: all arrays); curves: " + surface_extensions(true) +
                                    ". {step} in the name: a file for each step of INPUT"))
      ->type_name("FILE")
      ->required();
  add_mode_option(app, options->modes)->required(false);
  app.add_flag("--generalized", command.generalized, "With each mode M, also -M");
  app.add_option("--resolution", command.sampling.resolution,
                 "Samples per radian of turning of the medium eigenvector (curves: dominant); at "
                 "most 1000")
      ->type_name("R")
      ->capture_default_str();
  app.add_option("--max-error", command.max_error,
                 "Sample until the distance between triangles and level is proved to be below this")
      ->type_name("E")
      ->check(positive_number());
  app.add_option(
         "--uncertainty", command.uncertainty,
         "Say what is the same for all fields whose deviators differ by at most E: in units "
         "of the tensor (Frobenius norm), or E% of each vertex' deviator, or "
         "array:NAME, an array of the points of FIELD with a radius for each; of surfaces and "
         "of degenerate curves")
      ->type_name("E");
  app.add_option(
         "--min-persistence", command.min_persistence,
         "Leave out whole components that matter less: surfaces beside which the mode does "
         "not rise or not fall by P, curves whose component of the mode meets an older one "
         "within P; radians of the signed Lode angle arcsin(mode) / 3. What survives noise "
         "of r |deviator| at every point has a persistence of 2 arcsin r")
      ->type_name("P")
      ->check(positive_number());
  app.add_option("--min-area", command.min_area,
                 "Leave out whole components of surfaces with less area, in units of the mesh")
      ->type_name("A")
      ->check(positive_number());
  app.add_option("--min-length", command.min_length,
                 "Leave out whole components of degenerate curves with less length")
      ->type_name("L")
      ->check(positive_number());
  app.add_flag("--improve", command.improve,
               "Flip edges and move vertices within their tetrahedra and faces for better angles");
  app.add_flag("--all-samples", command.all_samples,
               "Keep samples of face curves that make needles and that the level can do without");
  auto* pieces = app.add_option("--pieces", command.pieces,
                 "Extract so many pieces (slabs) of the mesh one after the other: the same surfaces "
                 "and curves, bit for bit. For fields larger than memory see --stream")
      ->check(CLI::Range(1, 1000000))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--memory", options->memory,
                 "Extract surfaces in as many pieces (--pieces) as keep the program below so much "
                 "memory, or write nothing: bytes, or with a unit as 500M, 8G (powers of 1000) or "
                 "2GiB. The field is in memory as a whole; else see --stream")
      ->type_name("BYTES")
      ->excludes(pieces);
  app.add_flag("--stream", command.stream,
               "Read the pieces of a .pvtu one after the other, for fields larger than memory: the "
               "same surfaces and curves, bit for bit");
  app.add_option("--method", options->method,
                 "How to extract: sheets that turn far by bisection of edges, or on the medium "
                 "eigenvector manifold, as in the paper; all others only compare. 'graph': old name of "
                 "bisection, deprecated")
      ->transform(CLI::Transformer(std::map<std::string, std::string>{{"graph", "bisection"}}))
      ->check(CLI::IsMember({"bisection", "manifold", "marching", "a-patches", "hybrid",
                             "vtk-contour-grid", "vtk-contour-3d-linear-grid"}))
      ->capture_default_str();
  app.add_option("--patch-samples", options->baseline.samples,
                 "Samples along each side of a patch (method a-patches)")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--flatness", options->baseline.flatness,
                 "Largest distance from the surface, in edges of the tetrahedron (method hybrid)")
      ->check(number_from(1e-9, 1, "number from 1e-9 to 1"))
      ->capture_default_str();
  app.add_option(
         "--subdivide", command.subdivisions,
         "Cut each tetrahedron in eight beforehand, so many times (methods that only compare)")
      ->check(CLI::Range(0, 6))
      ->capture_default_str();
  add_invariant_option(app, options->invariant,
                       {"--mode", "--generalized", "--resolution", "--max-error", "--improve",
                        "--method", "--patch-samples", "--flatness", "--subdivide", "--all-samples",
                        "--uncertainty", "--min-persistence", "--min-area", "--min-length", "--memory", "--stream"});
  writes(common,
         app.add_option("--certify", command.certificate,
                        "Also prove the topology and distances; the certificate (.json or .cbor)"))
      ->type_name("CERT");
  app.add_flag(
      "--strict", command.strict,
      "If a tetrahedron stays unresolved, a surface is not embedded, off its mode or farther than "
      "--max-error, or the field has no mode anywhere, write nothing and exit with 1; if the mesh "
      "is torn (faces lie on others without being shared), with 3");
  add_read_options(app, common, command.read);
  add_common_options(app, common);
  app.callback([options, &common, &action] {
    action = [options, &common] { return extract(*options, common); };
  });
}

}  // namespace tensortopo
