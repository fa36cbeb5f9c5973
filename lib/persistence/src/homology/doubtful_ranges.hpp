// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/persistence/merge_tree.hpp"

namespace tensortopo::persistence {

/// For each merge that is not proved: from its mode down to that at which all that it touches is
/// one component anyway, by proved merges. There it does not matter any more; or down to -2, where
/// it is not known what it touches.
std::vector<ModeRange> doubtful_ranges(const MergeTree& tree);

}  // namespace tensortopo::persistence
