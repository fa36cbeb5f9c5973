// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tensortopo/persistence/merge_tree.hpp"

namespace tensortopo {

/// A component of {mode >= m}: it is there from the mode at which it is born down to the one at
/// which it meets an older one.
struct MergePair {
  std::size_t maximum = 0;           ///< as an index into `MergeTree::maxima`
  std::optional<std::size_t> merge;  ///< into `MergeTree::merges`; none if it meets no other
  /// Enclosures overlap: with other values in them the maximum would meet another one, or
  /// elsewhere. (Curves are all born at 1: there the longer one counts as the older, and it is a
  /// tie if the lengths agree to nine digits.)
  bool is_tie = false;
  /// Not so if a point whose link or whose path is not proved may have joined the component to an
  /// older one before; then it may have died earlier.
  bool is_certain = true;
};

/// Pairs by the elder rule, one for each maximum, in the order of the maxima.
std::vector<MergePair> persistence_pairs(const MergeTree& tree);

}  // namespace tensortopo
