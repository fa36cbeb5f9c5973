// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include "generate/generate_command.hpp"
#include "program/options/mode_option.hpp"
#include "program/output/progress_bar.hpp"
#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"

namespace tensortopo {
namespace {

struct GenerateOptions {
  GenerateCommand command;
  std::string kind;
  std::vector<std::string> modes;
};

ExitStatus generate(const GenerateOptions& options, const CommonOptions& common) {
  GenerateCommand command = options.command;
  command.kind = *field_kind(options.kind);
  command.modes = parse_modes(options.modes);
  ProgressBar bar(!common.quiet);
  const GenerateReport report = run_generate(command, bar.callback());
  bar.erase();
  for (const Generated& file : report.files) say_notes(file.field, file.notes, common.quiet);
  print_report(
      common, "generate", [&] { return to_json(report); }, [&] { return to_text(report); });
  return ExitStatus::done;
}

}  // namespace

void add_generate_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "generate", "Write fields with the certified truth about their mode surfaces");
  const auto options = std::make_shared<GenerateOptions>();
  GenerateCommand& command = options->command;
  std::vector<std::string> kinds;
  for (const FieldKind kind : all_field_kinds()) kinds.emplace_back(name_of(kind));
  app.add_option(
         "KIND", options->kind,
         "linear: a random tetrahedron; complex: a cubic polynomial on a small mesh; rough: "
         "random tensors on it; bifurcation: tetrahedra around their saddle, as the level "
         "passes it; planar-extrema: faces with 2, 3 and 4 extrema; nongeneric: one case for "
         "each degenerate configuration; boussinesq: loads on a half space; kelvin: a force in an "
         "infinite "
         "body; helix: a helix as degenerate curve; block: four blocks with a closed-form "
         "stand-in stress (no finite-element solution)")
      ->required()
      ->check(CLI::IsMember(kinds))
      ->type_name("KIND");
  writes(common,
         app.add_option("-o,--output", command.output,
                        "Field to write; beside it FILE.truth.json, FILE.reference.vtp and .json"))
      ->required()
      ->type_name("FILE.vtu");
  app.add_option("--seed", command.seed, "Which fields; the same bytes everywhere")
      ->type_name("S")
      ->check(whole_number())
      ->capture_default_str();
  app.add_option("--count", command.count, "Members of the family: FILE-0000.vtu and so on")
      ->type_name("N")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  app.add_flag("--together", command.together, "All members in one file, scaled and side by side");
  auto* modes = add_mode_option(app, options->modes)
                    ->required(false)
                    ->description("Mode M of the truth; repeatable (default: those of the kind)");
  app.add_option("--tets", command.tetrahedra, "At least so many tetrahedra, for kinds with a mesh")
      ->type_name("T")
      ->check(CLI::Range(1, 100000000));
  app.add_option("--pieces", command.pieces,
                 "Write the field as so many pieces (kind kelvin, FILE.pvtu, with --field-only), "
                 "never holding more than one")
      ->type_name("K")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  auto* always = app.add_flag("--reference", command.always_reference,
                              "Reference surfaces also for more than 10000 tetrahedra");
  auto* never =
      app.add_flag("--no-reference", command.no_reference, "No reference surface, only facts")
          ->excludes(always);
  app.add_flag("--field-only", command.field_only, "Write the field, no truth")
      ->excludes(modes)
      ->excludes(always)
      ->excludes(never);
  add_common_options(app, common);
  app.callback([options, &common, &action] {
    action = [options, &common] { return generate(*options, common); };
  });
}

}  // namespace tensortopo
