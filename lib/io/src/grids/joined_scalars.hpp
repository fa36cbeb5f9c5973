// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "grids/raw_grid.hpp"

namespace tensortopo::detail {

/// One array of arrays of one component each, in their order; without names of components.
ArraySource joined(std::string name, std::span<const ArraySource> parts);

/// Adds to arrays of one component the tensors that their names spell: six or nine names that are
/// alike but for `xx`, `xy`, ... (or `11`, ...) at the end. For formats that have scalars only.
void add_joined_scalars(std::vector<ArraySource>& arrays);

}  // namespace tensortopo::detail
