// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "formats/field_format.hpp"

namespace tensortopo::detail {

/// One step of a .pvd collection: the grids of the files that it names for one time, its parts.
/// Times are in the order in which the collection lists them first. Throws IoError.
std::vector<RawGrid> read_pvd(const FieldSource& source);

/// What each of its steps is.
std::vector<std::string> pvd_steps(const std::shared_ptr<const InputFile>& file);

}  // namespace tensortopo::detail
