// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace tensortopo {

/// The program's manual page, of section 1, made of what `--help` says.
/// @param footer  lines on exit statuses
std::string manual_page(const CLI::App& program, const std::string& footer);

}  // namespace tensortopo
