// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/options/invariant_option.hpp"

#include <iostream>
#include <stdexcept>

#include "program/output/progress_bar.hpp"
#include "program/output/report_output.hpp"
#include "tensortopo/analysis/invariant_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {

void add_invariant_option(CLI::App& app, InvariantOption& option,
                          const std::vector<std::string>& others) {
  auto* invariant = app.add_option("--invariant", option.invariant,
                                   "Instead of the mode: |T|, |D| or |D| / |T| for deviator D")
                        ->check(CLI::IsMember({"magnitude", "deviator-magnitude", "anisotropy"}));
  app.add_option("--value", option.values,
                 "Value of the invariant, a decimal or a fraction, taken exactly; repeatable")
      ->type_name("V")
      ->allow_extra_args(false)
      ->needs(invariant);
  auto* parts =
      app.add_option("--edge-parts", option.pieces,
                     "Parts in which an edge of a tetrahedron is cut (surfaces of invariants)")
          ->check(CLI::Range(1, 256))
          ->capture_default_str()
          ->needs(invariant);
  if (app.get_option_no_throw("--pieces") == nullptr)
    app.add_option("--pieces", option.pieces, "Old name of --edge-parts, deprecated")
        ->check(CLI::Range(1, 256))
        ->needs(invariant)
        ->excludes(parts);
  for (const std::string& name : others) invariant->excludes(app.get_option(name));
}

std::vector<InvariantLevel> levels_of(const InvariantOption& option) {
  if (option.values.empty()) throw UsageError("--invariant " + option.invariant + ": no --value");
  std::vector<InvariantLevel> levels;
  for (const std::string& text : option.values) {
    try {
      levels.push_back(InvariantLevel::parse(*invariant_named(option.invariant), text));
    } catch (const std::invalid_argument& problem) {
      throw UsageError("--value " + text + ": " + problem.what());
    }
  }
  return levels;
}

ExitStatus extract_invariant(const InvariantOption& option, const ExtractCommand& command,
                             const CommonOptions& common) {
  InvariantCommand own;
  own.input = command.input;
  own.output = command.output;
  own.certificate = command.certificate;
  own.read = command.read;
  own.provenance = command.provenance;
  own.strict = command.strict;
  own.pieces = option.pieces;
  own.levels = levels_of(option);
  ProgressBar bar(!common.quiet);
  const InvariantReport report = run_invariant_extract(own, bar.callback());
  bar.erase();
  say_notes(report.input, report.notes, common.quiet);
  const std::string unresolved = unresolved_line(report);
  if (!unresolved.empty())
    std::cerr << "tensortopo: " << report.input.string() << ": " << unresolved
              << (report.written ? "" : "; nothing written") << '\n';
  print_report(common, "extract-invariant", [&] { return to_json(report); }, [&] { return to_text(report); });
  if (say_undecided(report.certificate, common.quiet)) return ExitStatus::undecided;
  return own.strict && !unresolved.empty() ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace tensortopo
