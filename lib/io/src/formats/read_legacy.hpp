// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "formats/field_format.hpp"

namespace tensortopo::detail {

/// The grid of a legacy .vtk file (versions up to 5.1, ASCII or binary). Notes that a number ends
/// with the file. Throws IoError.
RawGrid read_legacy(const FieldSource& source);

}  // namespace tensortopo::detail
