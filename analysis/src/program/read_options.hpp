// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <string>

#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// How to read a mesh with tensors, in the same words wherever one is read: --tensor, --components,
/// --symmetrize, --cell-to-point and --tetrahedralize. `options` must outlive the parsing.
void add_read_options(CLI::App& app, ReadOptions& options);

/// Throws UsageError if one of these was given: no mesh is read.
void refuse_read_options(const CLI::App& app, const std::string& why);

}  // namespace tensortopo
