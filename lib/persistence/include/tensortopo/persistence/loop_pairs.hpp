// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tensortopo/persistence/merge_tree.hpp"

namespace tensortopo {

/// Loops appear or vanish in a component of {mode >= m} as m falls.
struct LoopChange {
  ModeRange mode;                     ///< where
  bool is_birth = true;               ///< they appear
  bool is_open = false;               ///< not known whether they do, or vanish
  std::size_t count = 1;              ///< how many
  std::optional<std::size_t> member;  ///< a maximum of the component; nothing: it is not known which
  std::size_t point = 0;              ///< the critical point; of curves a number of their own
  std::size_t event = 0;              ///< what the caller calls it
};

/// One loop, or several with the same birth or the same death, in one component.
struct LoopPair {
  std::size_t birth = 0;             ///< the caller's number
  std::optional<std::size_t> death;  ///< the caller's number; nothing: it lasts to the end
  bool is_tie = false;               ///< enclosures of changes to the component overlap
};

/// The pairs that follow from which component each change is in.
///
/// Loops of different components are independent. So where the last loop of a component vanishes,
/// all that were born in it, or in components that it came from, have died by changes in these. If
/// this is one loop, or all are born at one and the same mode, or die at one, their pairs are known.
/// From a merge that is not proved on, or a change that is open, nothing is said of the components
/// that it touches; from a change on whose component is not known, of any.
/// @param doubtful  maxima of components of which nothing is said
std::vector<LoopPair> loop_pairs(const MergeTree& tree, const std::vector<LoopChange>& changes,
                                 const std::vector<std::size_t>& doubtful);

}  // namespace tensortopo
