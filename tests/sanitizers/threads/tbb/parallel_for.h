// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// \file
/// Stands in for TBB's header under the thread sanitizer. The sanitizer does not see how the
/// packaged libtbb synchronises, takes every hand-over for a race, and would have to be told to
/// ignore all that runs below TBB: our loops. Plain threads it understands.

#include <tbb/blocked_range.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
  const Value grain = static_cast<Value>(std::max<std::size_t>(1, range.grainsize()));
  std::atomic<Value> next{range.begin()};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    // Relaxed: the counter must not order the bodies, or it would hide their races.
    for (;;) {
      const Value first = next.fetch_add(grain, std::memory_order_relaxed);
      if (first >= range.end()) return;
      try {
        body(blocked_range<Value>(first, std::min<Value>(range.end(), first + grain)));
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) threads.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
}

template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
  const Index grain = std::max<Index>(1, (last - first) / 16);
  parallel_for(blocked_range<Index>(first, last, static_cast<std::size_t>(grain)),
               [&](const auto& range) {
                 for (Index i = range.begin(); i != range.end(); ++i) body(i);
               });
}

}  // namespace tbb
