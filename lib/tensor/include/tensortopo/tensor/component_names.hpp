// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
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

/// The names of an array's components, and a caller, say no order, or two.
class ComponentNamesError : public std::runtime_error {
 public:
  /// @param contradicts_caller  names spell an order, and the caller says another one
  ComponentNamesError(const std::string& text, bool contradicts_caller)
      : std::runtime_error(text), contradicts_caller_(contradicts_caller) {}

  /// Names spell an order, and the caller says another one.
  bool contradicts_caller() const noexcept { return contradicts_caller_; }

 private:
  bool contradicts_caller_;
};

/// How an error names the array, and what a caller says the order with.
struct ComponentsWording {
  std::string array;   ///< "the components of `array` are named ..."
  std::string option;  ///< "say the order with `option`": "--components", ...
};

/// The order of six or nine components: what their names spell, else what the caller says, else
/// VTK's of six and row by row of nine.
///
/// Names are obeyed or refused: an order that they spell holds. Names that are not understood are
/// taken only if the caller says an order, and none of them ends in another entry (`tau_xy`, `E12`).
/// @param names  by `spelled_components`; none, or one for each component
/// @throw ComponentNamesError  if the caller says another order than the names; the names spell one
/// that `ComponentOrder` does not have; two are the same, or the same entry of a symmetric tensor;
/// or they are not understood and the caller says nothing, or an order that some of them contradict
TensorComponents decide_order(const std::vector<std::string>& names, std::size_t count,
                              std::optional<ComponentOrder> asked,
                              const ComponentsWording& wording);

}  // namespace tensortopo
