// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <string>

#include "program/subcommands/subcommands.hpp"

namespace tensortopo {

/// How `--help` looks: without the list of options that an option excludes, which for some is
/// longer than what they do; with exit statuses and where to read on at the end.
/// @post applies to subcommands that are added later
void set_help_style(CLI::App& program);

/// `tensortopo help [TOPIC]`: the help of a subcommand, the page on conventions, a manual page
/// (troff), or completion for bash.
void add_help_subcommand(CLI::App& program, CommonOptions& common, Action& action);

/// The first word that is neither an option of the subcommand nor its value, as one line with the
/// nearest option or subcommand; "" if all words are understood.
std::string unknown_word(const CLI::App& program, int argc, const char* const* argv);

}  // namespace tensortopo
