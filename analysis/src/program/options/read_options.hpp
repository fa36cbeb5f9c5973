// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

#include "program/options/common_options.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// What stands in the name of an output for the number of a step.
inline constexpr std::string_view kStep = "{step}";

/// How to read a field, in the same words wherever one is read: --tensor, --components and all
/// others. `options` must outlive the parsing.
void add_read_options(CLI::App& app, CommonOptions& common, ReadOptions& options);

/// "Field: .vtu, .pvtu, ...": what INPUT may be, of the table of formats.
std::string field_help();

/// Throws UsageError if one of these was given: no mesh is read.
void refuse_read_options(const CLI::App& app, const std::string& why);

/// Those that were given, as words of a command line.
std::vector<std::string> given_read_options(const CLI::App& app);

}  // namespace tensortopo
