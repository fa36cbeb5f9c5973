// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "bytes/input_file.hpp"
#include "grids/raw_grid.hpp"

namespace tensortopo::detail {

/// The grid of a legacy .vtk file (versions up to 5.1, ASCII or binary). Throws IoError.
/// @param for_certificate  as in ReadOptions
RawGrid read_legacy(const std::shared_ptr<const InputFile>& file, bool for_certificate = false);

}  // namespace tensortopo::detail
