// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <nlohmann/json.hpp>

#include "program/options/common_options.hpp"
#include "counted.hpp"
#include "program/options/read_options.hpp"
#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/write_mesh.hpp"

namespace tensortopo {
namespace {

struct ConvertOptions {
  std::filesystem::path input, output;
  ReadOptions read;
};

ExitStatus convert(const ConvertOptions& options, const CommonOptions& common) {
  if (lower_extension(options.output) != ".vtu")
    throw UsageError(options.output.string() + ": -o must end in .vtu");
  if (options.output.string().find(kStep) != std::string::npos)
    throw UsageError(options.output.string() +
                     ": convert writes one step, which --step chooses; {step} is for extract");
  const ReadResult read = read_mesh(options.input, options.read);
  write_mesh(read.mesh, options.output, read.report.tensor_name);
  say_notes(options.input, read.report.all_notes(), common.quiet);
  const std::size_t points = read.mesh.points.size(), tets = read.mesh.tets.size();
  if (common.json) {
    const nlohmann::ordered_json json{
        {"input",
         {{"path", options.input.string()},
          {"sha256", read.sha256},
          {"tensor", read.report.tensor_name},
          {"components", name_of(read.report.components.order)},
          {"notes", read.report.notes}}},
        {"output",
         {{"path", options.output.string()}, {"vertices", points}, {"tetrahedra", tets}}}};
    constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
    print(with_provenance(json.dump(-1, ' ', false, replace), common, "convert"));
  } else {
    if (common.quiet) return ExitStatus::done;
    print(options.output.string() + ": " + counted(points, "vertex", "vertices") + ", " +
          counted_tets(tets) + ", tensor '" + read.report.tensor_name + "'\n");
  }
  return ExitStatus::done;
}

}  // namespace

void add_convert_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "convert", "Write the tetrahedra and tensors that are read, as all other commands take them");
  const auto options = std::make_shared<ConvertOptions>();
  reads(common, app.add_option("INPUT", options->input, field_help()))
      ->required();
  writes(common, app.add_option("-o,--output", options->output, "The field (.vtu)"))
      ->type_name("FILE")
      ->required();
  add_read_options(app, common, options->read);
  add_common_options(app, common);
  app.callback([options, &common, &action] {
    action = [options, &common] { return convert(*options, common); };
  });
}

}  // namespace tensortopo
