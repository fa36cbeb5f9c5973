// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tensortopo {

/// How many signs each kind of arithmetic has settled: double with an error bound, longer floating
/// point numbers with one, rationals.
struct PredicateCounts {
  /// Signs settled in double, in longer floating point numbers, and in rationals.
  std::uint64_t fast = 0, multiprecision = 0, exact = 0;

  /// What was counted between two moments.
  friend PredicateCounts operator-(const PredicateCounts& p, const PredicateCounts& q) {
    return {p.fast - q.fast, p.multiprecision - q.multiprecision, p.exact - q.exact};
  }
};

/// The counts of this process so far, over all threads.
PredicateCounts predicate_counts();

}  // namespace tensortopo
