// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// See parallel_for.h. The sort itself is TBB's to check.

#include <algorithm>
#include <functional>

namespace tbb {

template <class Iterator, class Compare = std::less<>>
void parallel_sort(Iterator first, Iterator last, const Compare& compare = {}) {
  std::sort(first, last, compare);
}

}  // namespace tbb
