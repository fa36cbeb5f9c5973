// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The array `whole_component`: what parts say of which components are one in the whole.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "run/ledger.hpp"

namespace certificate {

/// What the array says of a component of a part.
struct SaidNumber {
  std::optional<double> whole;  ///< nothing if there is no such array
  bool whole_is_one = true;     ///< whether it says one number on all cells

  /// The number of another cell of the component.
  void hear(double number) { whole_is_one = whole_is_one && whole == number; }
};

/// One claim, if parts have the array: it is the same on two cells just if they are in one component
/// of the whole, and counts from 0.
/// @param said  of each part, of its components
/// @param number  of all these components, one part after the other, in the whole
/// @param count  how many components the whole has
/// @return whether the array is there, and right
bool compare_whole_numbers(const std::vector<std::vector<SaidNumber>>& said,
                           const std::vector<std::size_t>& number, std::size_t count,
                           Ledger& ledger);

}  // namespace certificate
