// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"
#include "proofs/proofs_command.hpp"

namespace tensortopo {

void add_proofs_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "proofs", "Prove the steps of the paper's proofs again, by exact arithmetic");
  const auto command = std::make_shared<ProofsCommand>();
  app.add_option("--step", command->steps, "A step by its id; repeatable (default: all)")
      ->type_name("ID")
      ->allow_extra_args(false);
  add_common_options(app, common);
  app.callback([command, &common, &action] {
    action = [command, &common] {
      const ProofsReport report = run_proofs(*command);
      print_report(
          common, "proofs", [&] { return report.json; }, [&] { return report.text; }, true);
      return report.all_established ? ExitStatus::done : ExitStatus::undecided;
    };
  });
}

}  // namespace tensortopo
