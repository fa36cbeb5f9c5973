// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "program/options/common_options.hpp"
#include "tensortopo/analysis/exit_status.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/quadric/invariant_level.hpp"

namespace tensortopo {

/// The words that ask `extract` for another invariant than the mode.
struct InvariantOption {
  std::string invariant;
  std::vector<std::string> values;
  int pieces = 2;
};

/// Adds `--invariant`, `--value` and `--edge-parts` (and its old name `--pieces`, unless the
/// command has an option of this name); the options named in `others` are for modes only.
void add_invariant_option(CLI::App& app, InvariantOption& option,
                          const std::vector<std::string>& others);

/// The surfaces that the words ask for. Throws UsageError.
std::vector<InvariantLevel> levels_of(const InvariantOption& option);

/// Does what `extract` does, with the input, output and reading options of `command`.
ExitStatus extract_invariant(const InvariantOption& option, const ExtractCommand& command,
                             const CommonOptions& common);

}  // namespace tensortopo
