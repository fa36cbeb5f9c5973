// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "formats/field_format.hpp"

namespace tensortopo::detail {

/// The pieces of a .vti file (VTK XML image), as lattices. Throws IoError.
std::vector<RawGrid> read_vti(const FieldSource& source);

}  // namespace tensortopo::detail
