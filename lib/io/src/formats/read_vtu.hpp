// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "bytes/input_file.hpp"
#include "grids/raw_grid.hpp"

namespace tensortopo::detail {

/// The pieces of a .vtu file. Throws IoError.
std::vector<RawGrid> read_vtu(const std::shared_ptr<const InputFile>& file);

/// The files that a .pvtu file names, resolved against its folder. Throws IoError.
std::vector<std::filesystem::path> read_pvtu(const std::shared_ptr<const InputFile>& file);

}  // namespace tensortopo::detail
