// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "program/options/invariant_option.hpp"
#include "program/options/mode_option.hpp"
#include "program/options/read_options.hpp"
#include "program/output/progress_bar.hpp"
#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"
#include "render/animation.hpp"
#include "render/render_command.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/lower_extension.hpp"

namespace tensortopo {
namespace {

struct RenderOptions {
  RenderCommand command;
  std::filesystem::path input, mesh;
  std::string tet, size, view, focus, texture, panels, direction, animation;
  InvariantOption invariant;
  std::vector<std::string> modes;
  const CLI::App* app = nullptr;  ///< knows which options were given
};

RenderCommand command_of(const RenderOptions& options) {
  RenderCommand command = options.command;
  if (!options.mesh.empty()) command.mesh = options.mesh;
  if (lower_extension(options.input) == ".vtp") {
    command.surfaces.insert(command.surfaces.begin(), options.input);
  } else if (command.mesh) {
    throw UsageError(options.input.string() + ": --mesh names the mesh, so this must be a .vtp");
  } else {
    command.mesh = options.input;
  }
  if (!command.mesh) refuse_read_options(*options.app, "is about a mesh (--mesh)");
  if (options.tet == "any") {
    command.any_tet = true;
  } else if (!options.tet.empty()) {
    std::int64_t id = 0;
    if (!CLI::detail::lexical_cast(options.tet, id))
      throw UsageError("--tet " + options.tet + ": no such tetrahedron");
    command.tet = id;
  }
  if (!options.size.empty()) parse_size(options.size, command.view);
  if (!options.view.empty()) parse_view(options.view, command.view);
  if (!options.focus.empty()) parse_focus(options.focus, command.view);
  command.modes = parse_modes(options.modes);
  if (!command.modes.empty()) command.modes = modes_to_extract(command.modes, false);
  if (!options.invariant.invariant.empty()) command.levels = levels_of(options.invariant);
  command.pieces = options.invariant.pieces;
  if (!options.animation.empty()) command.frames = parse_animation(options.animation);
  if (!options.texture.empty()) command.texture = parse_texture(options.texture);
  if (!options.panels.empty()) command.panels = parse_panels(options.panels);
  if (!options.direction.empty()) command.marked = parse_direction(options.direction);
  return command;
}

ExitStatus render(const RenderOptions& options, const CommonOptions& common) {
  const RenderCommand command = command_of(options);
  ProgressBar bar(!common.quiet);
  const RenderReport report = run_render(command, bar.callback());
  bar.erase();
  const std::string output = command.output.string();
  if (command.mesh) say_notes(*command.mesh, report.mesh_notes, common.quiet);
  for (const auto& file : report.empty)
    say_notes(file, {"holds no triangles and no lines, so nothing is drawn of it"}, common.quiet);
  say_notes(options.input, report.notes, common.quiet);
  if (common.json) {
    nlohmann::ordered_json json;
    // Frames of their own: there is no file of the name given.
    if (report.frames.empty() || is_film(command.output))
      json["output"] = {{"path", output}, {"bytes", report.bytes}};
    json.update({{"width", report.width},
                 {"height", report.height},
                 {"modes", report.modes},
                 {"seconds", report.seconds}});
    if (!report.values.empty()) json["values"] = report.values;
    if (report.bifurcation_mode) json["bifurcation_mode"] = *report.bifurcation_mode;
    for (const auto& [point, mode, drawn] : report.marked)
      json["direction"].push_back(
          {{"point", {point.x, point.y, point.z}}, {"mode", mode}, {"drawn", drawn}});
    if (!report.frames.empty()) {
      json["frames"] = nlohmann::ordered_json::array();
      for (const auto& file : report.frames) json["frames"].push_back(file.string());
    }
    for (const auto& file : report.empty) json["empty"].push_back(file.string());
    std::vector<std::string> notes = report.mesh_notes;
    notes.insert(notes.end(), report.notes.begin(), report.notes.end());
    if (!notes.empty()) json["notes"] = notes;
    print(with_provenance(
        json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace), common,
        "render"));
  } else if (!common.quiet) {
    const std::string files =
        report.frames.empty() || is_film(command.output)
            ? output
            : report.frames.front().string() + " to " + report.frames.back().filename().string();
    print(fmt::format("{}: {} x {} pixels ({:.1f} s)\n", files, report.width, report.height,
                      report.seconds));
  }
  return ExitStatus::done;
}

}  // namespace

void add_render_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand("render", "Draw surfaces to a PNG, without a display");
  const auto options = std::make_shared<RenderOptions>();
  options->app = &app;
  reads(common,
        app.add_option("INPUT", options->input,
                 "Surfaces or ridges (.vtp). " + field_help()))
      ->required();
  writes(common, app.add_option("-o,--output", options->command.output, "The picture"))
      ->type_name("FILE.png")
      ->required();
  reads(common, app.add_option("--surface", options->command.surfaces,
                               "More surfaces (.vtp); repeatable"))
      ->type_name("FILE")
      ->allow_extra_args(false);
  reads(common, app.add_option("--mesh", options->mesh, "The mesh, drawn as an outline"))
      ->type_name("FILE");
  app.add_option("--size", options->size,
                 "Pixels (default: 1600x1200; with --tet by the number of panels)")
      ->type_name("WIDTHxHEIGHT");
  app.add_option("--view", options->view,
                 "Where to look from, in degrees: right of the front, above the horizon "
                 "(default: 30,22)")
      ->type_name("AZIMUTH,ELEVATION");
  app.add_option("--focus", options->focus,
                 "The point of space in the middle of the picture (default: all is in view)")
      ->type_name("X,Y,Z");
  app.add_option("--zoom", options->command.view.zoom,
                 "A closer view: what is in space, so many times as large")
      ->type_name("F");
  add_mode_option(app, options->modes)
      ->required(false)
      ->description(
          "Extract this mode from the mesh and draw it; repeatable (with --tet: side by "
          "side)");
  app.add_flag("--generalized", options->command.generalized, "With each mode its opposite");
  app.add_option("--animate", options->animation,
                 "A frame for each of N modes from A to B: FILE-000.png and so on; with ffmpeg "
                 "and a FILE.gif or FILE.mp4 also a film")
      ->type_name("A:B:N");
  add_invariant_option(app, options->invariant, {"--mode", "--generalized", "--animate"});
  app.add_option("--texture", options->texture,
                 "Lines on the surface: major, minor (principal directions, by the field's "
                 "derivatives), or dominant (eigenvectors)")
      ->type_name("LINES");
  app.add_flag("--recover", options->command.recover,
               "With --texture major or minor: the principal directions of the smooth field, by "
               "derivatives recovered at the mesh's vertices");
  app.add_option(
         "--tet", options->tet,
         "Draw the medium eigenvector manifold and the surface of this tetrahedron, or of `any` "
         "that the surface meets; the cell data 'tet' of an extracted .vtp names all of those")
      ->type_name("ID|any")
      ->check([](const std::string& text) -> std::string {
        return text == "any" ? std::string() : whole_number()(text);
      });
  app.add_option("--panels", options->panels,
                 "With --tet: some of curves, manifold, triangles, surface, octant "
                 "(default: manifold,surface)")
      ->type_name("LIST");
  app.add_option("--beyond", options->command.beyond,
                 "With --tet: the tetrahedron's linear field, in a cube K times as large")
      ->type_name("K");
  app.add_option("--direction", options->direction,
                 "With --tet: mark a medium eigenvector and the points that have it")
      ->type_name("X,Y,Z");
  add_read_options(app, common, options->command.read);
  add_common_options(app, common);
  app.callback([options, &common, &action] {
    action = [options, &common] { return render(*options, common); };
  });
}

}  // namespace tensortopo
