// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/predicate_counts.hpp"

#include <array>
#include <atomic>
#include <cstddef>

#include "extract/run/count_predicate.hpp"

namespace tensortopo {

namespace {

/// Threads that count at one place would wait for each other: each has a cache line, unless there
/// are more threads than lines.
struct alignas(64) Line {
  std::array<std::atomic<std::uint64_t>, 3> counts{};
};
std::array<Line, 64> lines;
std::atomic<std::size_t> threads{0};

}  // namespace

void count_predicate(Tier tier) {
  thread_local Line& line = lines[threads++ % lines.size()];
  line.counts[static_cast<std::size_t>(tier)].fetch_add(1, std::memory_order_relaxed);
}

PredicateCounts predicate_counts() {
  PredicateCounts sum;
  for (const auto& line : lines) {
    sum.fast += line.counts[0];
    sum.multiprecision += line.counts[1];
    sum.exact += line.counts[2];
  }
  return sum;
}

}  // namespace tensortopo
