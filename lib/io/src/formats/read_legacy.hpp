// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "bytes/input_file.hpp"
#include "grids/raw_grid.hpp"

namespace tensortopo::detail {

/// The grid of a legacy .vtk file (versions up to 5.1, ASCII or binary). Throws IoError.
RawGrid read_legacy(const std::shared_ptr<const InputFile>& file);

}  // namespace tensortopo::detail
