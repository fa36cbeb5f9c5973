// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "files/file.hpp"
#include "files/grid.hpp"

namespace certificate {

/// Reads a legacy .vtk file with an unstructured grid, ASCII or BINARY (that is big-endian).
/// Throws Malformed.
Grid read_legacy_grid(const File& file, const std::string& tensor, std::size_t components);

}  // namespace certificate
