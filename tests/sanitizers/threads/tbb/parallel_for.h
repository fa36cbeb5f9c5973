// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// \file
/// Stands in for TBB's header under the thread sanitizer. The sanitizer does not see how the
/// packaged libtbb synchronises, takes every hand-over for a race, and would have to be told to
/// ignore all that runs below TBB: our loops. Plain threads it understands.

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
  constexpr std::size_t thread_count = 4;
  const std::size_t grain = std::max<std::size_t>(1, range.grainsize());
  std::exception_ptr failure;
  std::mutex mutex;
  // Chunks are dealt out beforehand: a counter that the threads share would order the bodies, and
  // hide their races.
  const auto work = [&](std::size_t thread) {
    try {
      for (std::size_t at = thread * grain; at < range.size(); at += thread_count * grain) {
        const std::size_t end = std::min(at + grain, range.size());
        body(blocked_range<Value>(range.begin() + static_cast<Value>(at),
                                  range.begin() + static_cast<Value>(end), grain));
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < thread_count; ++i) threads.emplace_back(work, i);
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
