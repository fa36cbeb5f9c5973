// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tensortopo/tensor/component_order.hpp"

namespace tensortopo {

/// Whether a file names the components of an array: some of the names are not empty.
bool are_named(const std::vector<std::string>& names);

/// The component of the tensor that each name spells: "XX", "XY", ... of the upper triangle, but as
/// spelled ("YX") if there are nine names; empty if one is not understood or two are the same.
///
/// What all names begin and end with is left out (`stress_xx`, `S11 (MPa)`). `x`, `y`, `z` in any
/// case, `1`, `2`, `3` or `0`, `1`, `2` are the axes, and a separator may stand between two of
/// them. One axis alone is a diagonal entry, if all three are spelled so.
std::vector<std::string> spelled_components(const std::vector<std::string>& names);

/// What the names of an array's components say about their order.
struct SpelledOrder {
  /// Of what the names say.
  enum class Kind {
    nothing,   ///< there are no names, or they are not understood
    order,     ///< `order`
    other,     ///< one that `ComponentOrder` does not have
    repeated,  ///< two components have the same name, or as an entry of a symmetric tensor
  };
  Kind kind = Kind::nothing;                   ///< what they say
  ComponentOrder order = ComponentOrder::vtk;  ///< if they spell one that we have
};

/// Of six or nine names, by `spelled_components`. An order that names spell holds, whatever else is
/// said; names that repeat one say that something is wrong.
SpelledOrder spelled_order(const std::vector<std::string>& names);

}  // namespace tensortopo
