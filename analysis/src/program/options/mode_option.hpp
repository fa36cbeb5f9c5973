// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Adds `--mode M` and `--mode A:B:N`, repeatable; values such as -0.5 and -9/10 are not mistaken
/// for options.
CLI::Option* add_mode_option(CLI::App& app, std::vector<std::string>& modes);

/// The exact values, those of A:B:N in place of it. Throws UsageError with the reason.
std::vector<ModeValue> parse_modes(const std::vector<std::string>& modes);

}  // namespace tensortopo
