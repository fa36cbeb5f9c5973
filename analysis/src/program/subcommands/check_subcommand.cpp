// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <iostream>
#include <memory>
#include <string>

#include "check/check_command.hpp"
#include "program/output/progress_bar.hpp"
#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"

namespace tensortopo {

void add_check_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "check", "Check a certificate with a program that shares no code with the extractor");
  const auto files = std::make_shared<std::array<std::string, 3>>();
  app.add_option("INPUT", (*files)[0], "The field: .vtu, legacy .vtk, .pvtu of a surface in parts")->required();
  app.add_option("OUTPUT", (*files)[1], "The surface: .vtp, or .pvtp with a certificate of parts")->required();
  app.add_option("CERT", (*files)[2], "The certificate: .json or .cbor")->required();
  const auto demands = std::make_shared<CheckDemands>();
  app.add_option("--expect-mode", demands->modes,
                 "A mode (1/2, -0.9) that must be certified; repeatable")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--expect-tensor", demands->tensor,
                 "The tensor array that the certificate must be about");
  app.add_flag("--expect-complete", demands->complete,
               "No tetrahedron may be left out, no other cell with a volume skipped; faces, lines "
               "and points are skipped, and the verdict counts them");
  add_common_options(app, common);
  app.callback([files, demands, &common, &action] {
    action = [files, demands, &common] {
      ProgressBar bar(!common.quiet);
      const CheckOutcome outcome = run_check((*files)[0], (*files)[1], (*files)[2], *demands, bar.callback());
      bar.erase();
      print_report(
          common, "check", [&] { return outcome.json; }, [&] { return outcome.text; });
      if (common.quiet && !outcome.all_certified)  // the reason, in one line
        std::cerr << "tensortopo: " << outcome.text.substr(0, outcome.text.find('\n')) << '\n';
      return outcome.all_certified ? ExitStatus::done : ExitStatus::undecided;
    };
  });
}

}  // namespace tensortopo
