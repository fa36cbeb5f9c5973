// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "program/options/common_options.hpp"
#include "tensortopo/analysis/provenance.hpp"

namespace tensortopo {

/// This program, and the options given to one of its subcommands.
Provenance provenance_of(const CLI::App& app, const CommonOptions& common);

}  // namespace tensortopo
