// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "program/options/common_options.hpp"
#include "tensortopo/analysis/exit_status.hpp"

namespace tensortopo {

/// A parsed subcommand, ready to run. Throws UsageError, IoError.
using Action = std::function<ExitStatus()>;

/// Each adds a subcommand to the program and sets `action` if the caller chooses it.
void add_analyze_subcommand(CLI::App& program, CommonOptions& common, Action& action);
void add_convert_subcommand(CLI::App& program, CommonOptions& common, Action& action);
void add_extract_subcommand(CLI::App& program, CommonOptions& common, Action& action);
void add_report_subcommand(CLI::App& program, CommonOptions& common, Action& action);
void add_render_subcommand(CLI::App& program, CommonOptions& common, Action& action);
void add_bench_subcommand(CLI::App& program, CommonOptions& common, Action& action);
void add_generate_subcommand(CLI::App& program, CommonOptions& common, Action& action);
void add_conformance_subcommand(CLI::App& program, CommonOptions& common, Action& action);
void add_verify_subcommand(CLI::App& program, CommonOptions& common, Action& action);
void add_check_subcommand(CLI::App& program, CommonOptions& common, Action& action);
void add_proofs_subcommand(CLI::App& program, CommonOptions& common, Action& action);

}  // namespace tensortopo
