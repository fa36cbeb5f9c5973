// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "program/options/read_options.hpp"
#include "program/output/progress_bar.hpp"
#include "program/output/report_output.hpp"
#include "program/subcommands/subcommands.hpp"
#include "verify/verify_command.hpp"

namespace tensortopo {

void add_verify_subcommand(CLI::App& program, CommonOptions& common, Action& action) {
  CLI::App& app =
      *program.add_subcommand("verify", "Check the paper's statements on linear fields, exactly");
  const auto command = std::make_shared<VerifyCommand>();
  app.add_option("--theorem", command->theorems,
                 "A statement by its id, or a result of the paper by its number, 1 to 6; "
                 "repeatable (default: all)")
      ->type_name("ID")
      ->allow_extra_args(false);
  app.add_option("--fields", command->fields, "Fields to try each on")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_option("--seed", command->seed, "Which fields; the same ones everywhere")
      ->type_name("S")
      ->check(whole_number())
      ->capture_default_str();
  app.add_option("--scalar", command->scalar,
                 "Numbers to decide with: rational decides everything; interval, real100 and "
                 "double carry an error bound, certify signs and leave equalities open")
      ->check(CLI::IsMember({"rational", "interval", "real100", "double"}))
      ->type_name("NAME")
      ->capture_default_str();
  app.add_option("--input", command->input, "Try the fields of this mesh's tetrahedra instead")
      ->type_name("MESH");
  add_read_options(app, common, command->read);
  add_common_options(app, common);
  app.callback([command, &app, &common, &action] {
    action = [command, &app, &common] {
      if (command->input.empty()) refuse_read_options(app, "is about a mesh (--input)");
      ProgressBar bar(!common.quiet);
      const VerifyReport report = run_verify(*command, bar.callback());
      bar.erase();
      if (report.mesh) say_notes(report.mesh->file, report.mesh->notes, common.quiet);
      print_report(
          common, "verify", [&] { return to_json(report); }, [&] { return to_text(report); }, true);
      return report.all_established() ? ExitStatus::done : ExitStatus::undecided;
    };
  });
}

}  // namespace tensortopo
