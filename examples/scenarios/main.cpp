// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include "deck.hpp"
#include "field_difference.hpp"
#include "mesh_difference.hpp"
#include "scenario.hpp"
#include "solution.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/io/write_text.hpp"

namespace {

using namespace tensortopo;
using namespace tensortopo::scenarios;

struct Options {
  std::string name, output, job, first, second;
  bool small = false, direct = false, iterative = false;
  Scenario scenario() const { return make_scenario(name, small ? Size::small : Size::full); }
};

void write_deck(const Options& options) {
  const Scenario scenario = options.scenario();
  // A direct solve of a full block takes too much memory.
  const bool direct = options.direct || (options.small && !options.iterative);
  write_text(options.output, deck(scenario, direct ? Solver::direct : Solver::iterative));
  fmt::print("{}: {} hexahedra, {} nodes\n", options.output, scenario.mesh.hexes.size(),
             scenario.mesh.points.size());
}

void write_field(const Options& options) {
  const Solution solution = read_solution(options.scenario(), options.job);
  write_mesh(solution.field, options.output);
  fmt::print("{}: {} tetrahedra, {} points\n{}", options.output, solution.field.tets.size(),
             solution.field.points.size(), to_text(solution.checks));
}

void compare(const Options& options) {
  fmt::print(
      "{}", to_text(compare_fields(read_mesh(options.first).mesh, read_mesh(options.second).mesh)));
}

void write_difference(const Options& options) {
  const TetMesh mesh = read_mesh(options.first).mesh;
  const auto radii = deviator_differences(mesh, read_mesh(options.second).mesh);
  write_mesh(mesh, options.output, "stress", {{"difference", radii}});
  fmt::print("{}: {} points, deviators differ by at most {:.6g}\n", options.output, radii.size(),
             *std::max_element(radii.begin(), radii.end()));
}

void add_scenario(CLI::App& app, Options& options) {
  app.add_option("NAME", options.name, "Which block")
      ->required()
      ->check(CLI::IsMember(scenario_names()))
      ->type_name("NAME");
  app.add_flag("--small", options.small, "6000 to 7488 tetrahedra, not 286,416 to 480,000");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Stress fields of loaded blocks: decks for CalculiX, and fields from its results",
               "tensortopo_scenario"};
  app.require_subcommand(1);
  Options options;
  auto* deck_command = app.add_subcommand("deck", "Write the input file of a block for CalculiX");
  add_scenario(*deck_command, options);
  deck_command->add_option("-o,--output", options.output, "Deck to write")
      ->required()
      ->type_name("JOB.inp");
  auto* direct = deck_command->add_flag("--direct", options.direct,
                                        "Direct solver (default of the small blocks)");
  deck_command
      ->add_flag("--iterative", options.iterative, "Iterative solver (default of the full blocks)")
      ->excludes(direct);
  auto* field_command = app.add_subcommand(
      "field", "Check CalculiX's results and write the stress as a field of tetrahedra");
  add_scenario(*field_command, options);
  field_command->add_option("--job", options.job, "Results are JOB.rout, JOB.frd and JOB.dat")
      ->required()
      ->type_name("JOB");
  field_command->add_option("-o,--output", options.output, "Field to write")
      ->required()
      ->type_name("FILE.vtu");
  auto* compare_command =
      app.add_subcommand("compare", "Say how far two fields on one mesh are from each other");
  compare_command->add_option("FIRST", options.first)->required()->type_name("FILE.vtu");
  compare_command->add_option("SECOND", options.second)->required()->type_name("FILE.vtu");
  auto* difference_command = app.add_subcommand(
      "difference",
      "Write the first field with an array `difference`: by how much the deviators of the second, on "
      "another mesh of the solid, differ at its points");
  difference_command->add_option("FIRST", options.first)->required()->type_name("FILE.vtu");
  difference_command->add_option("SECOND", options.second)->required()->type_name("FILE.vtu");
  difference_command->add_option("-o,--output", options.output, "Field to write")
      ->required()
      ->type_name("FILE.vtu");
  CLI11_PARSE(app, argc, argv);
  try {
    if (deck_command->parsed()) write_deck(options);
    if (field_command->parsed()) write_field(options);
    if (compare_command->parsed()) compare(options);
    if (difference_command->parsed()) write_difference(options);
  } catch (const std::exception& error) {
    std::cerr << "tensortopo_scenario: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
