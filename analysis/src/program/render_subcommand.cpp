// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "program/progress_bar.hpp"
#include "program/report_output.hpp"
#include "program/subcommands.hpp"
#include "render/render_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {
namespace {

struct Options {
  RenderCommand command;
  std::filesystem::path input, mesh;
  std::string size, view;
};

RenderCommand command_of(const Options& options) {
  RenderCommand command = options.command;
  if (!options.mesh.empty()) command.mesh = options.mesh;
  if (options.input.extension() == ".vtp") {
    command.surfaces.insert(command.surfaces.begin(), options.input);
  } else if (command.mesh) {
    throw UsageError(options.input.string() + ": --mesh names the mesh, so this must be a .vtp");
  } else {
    command.mesh = options.input;
  }
  if (!options.size.empty()) parse_size(options.size, command.view);
  if (!options.view.empty()) parse_view(options.view, command.view);
  return command;
}

ExitStatus render(const Options& options, const CommonOptions& common) {
  const RenderCommand command = command_of(options);
  ProgressBar bar(!common.quiet);
  const RenderReport report = run_render(command, bar.callback());
  bar.erase();
  const std::string output = command.output.string();
  if (common.json) {
    const nlohmann::ordered_json json{{"output", {{"path", output}, {"bytes", report.bytes}}},
                                      {"width", command.view.width},
                                      {"height", command.view.height},
                                      {"modes", report.modes},
                                      {"seconds", report.seconds}};
    print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
  } else {
    print(fmt::format("{}: {} x {} pixels ({:.1f} s)\n", output, command.view.width,
                      command.view.height, report.seconds));
  }
  return ExitStatus::done;
}

}  // namespace

void add_render_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand("render", "Draw surfaces to a PNG, without a display");
  const auto options = std::make_shared<Options>();
  app.add_option("INPUT", options->input, "Surfaces (.vtp), or the mesh (.vtu, .pvtu, .vtk)")
      ->required();
  app.add_option("-o,--output", options->command.output, "The picture")
      ->type_name("FILE.png")
      ->required();
  app.add_option("--surface", options->command.surfaces, "More surfaces (.vtp); repeatable")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--mesh", options->mesh, "The mesh, drawn as an outline")->type_name("FILE");
  app.add_option("--size", options->size, "Pixels (default: 1600x1200)")->type_name("WIDTHxHEIGHT");
  app.add_option("--view", options->view,
                 "Where to look from, in degrees: right of the front, above the horizon "
                 "(default: 30,22)")
      ->type_name("AZIMUTH,ELEVATION");
  add_common_options(app, common);
  app.callback([options, &common, &action] {
    action = [options, &common] { return render(*options, common); };
  });
}

}  // namespace tensortopo
