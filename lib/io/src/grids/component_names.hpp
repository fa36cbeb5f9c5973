// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tensortopo/io/component_order.hpp"

namespace tensortopo::detail {

/// Whether a file names the components of an array: some of the names are not empty.
bool are_named(const std::vector<std::string>& names);

/// The component of the tensor that each name spells: "XX", "XY", ... of the upper triangle, but as
/// spelled ("YX") if there are nine names; empty if one is not understood or two are the same.
///
/// What all names begin and end with is left out (`stress_xx`, `S11 (MPa)`). `x`, `y`, `z` in any
/// case, `1`, `2`, `3` or `0`, `1`, `2` are the axes, and a separator may stand between two of
/// them. One axis alone is a diagonal entry, if all three are spelled so.
std::vector<std::string> spelled_components(const std::vector<std::string>& names);

/// The order that the names of six or nine components spell; empty if they spell none that we have.
std::optional<ComponentOrder> spelled_order(const std::vector<std::string>& names);

}  // namespace tensortopo::detail
