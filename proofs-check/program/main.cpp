// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// tensortopo_proofs [--mutate | --json | --markdown] [--step ID]...
//
// Proves the steps and prints a table. With --mutate: changes one constant at a time, in every
// step, and reports whether all changes are noticed.
// Exit status: 0 all is as it should be, 1 something is not, 2 wrong usage.
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "proof_steps/report.hpp"

namespace {

struct Arguments {
  std::string output;  ///< an option, or empty for the table
  std::vector<std::string> steps;
  bool valid = true;
};

Arguments parse(const std::vector<std::string>& words) {
  const std::vector<std::string> outputs{"--mutate", "--json", "--markdown"};
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--step" && i + 1 < words.size()) {
      arguments.steps.push_back(words[++i]);
    } else if (std::find(outputs.begin(), outputs.end(), words[i]) != outputs.end()) {
      arguments.output = words[i];
    } else {
      arguments.valid = false;
    }
  }
  const std::vector<std::string> ids = proofs::step_ids();
  for (const std::string& id : arguments.steps)
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) arguments.valid = false;
  return arguments;
}

bool mutate(const std::vector<std::string>& steps) {
  const auto results = proofs::run_mutations(steps);
  std::cout << proofs::to_text(results);
  return std::all_of(results.begin(), results.end(), [](const auto& r) { return r.passed(); });
}

bool prove(const Arguments& arguments) {
  const auto results = proofs::run_steps(arguments.steps);
  if (arguments.output == "--json") {
    std::cout << proofs::to_json(results, proofs::machine_checked()) << '\n';
  } else if (arguments.output == "--markdown") {
    std::cout << proofs::to_markdown(results);
  } else {
    if (arguments.steps.empty()) std::cout << proofs::to_text(proofs::machine_checked()) << '\n';
    std::cout << proofs::to_text(results);
  }
  return std::all_of(results.begin(), results.end(),
                     [](const auto& r) { return proofs::is_established(r.verdict); });
}

}  // namespace

int main(int argc, char** argv) try {
  const Arguments arguments = parse({argv + 1, argv + argc});
  if (!arguments.valid) {
    std::cerr << "usage: tensortopo_proofs [--mutate | --json | --markdown] [--step ID]...\n";
    return 2;
  }
  const bool passed = arguments.output == "--mutate" ? mutate(arguments.steps) : prove(arguments);
  std::cout.flush();
  return passed && std::cout ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "tensortopo_proofs: " << error.what() << '\n';
  return 1;
}
