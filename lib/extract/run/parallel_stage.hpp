// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <string_view>

#include "tensortopo/extract/extract_options.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

/// Runs a body for the indices in parallel, from the first of some to the one after their last, and
/// reports how far it is. The bodies write to places of their own, so the result does not depend on
/// the number of threads. Error bounds hold for rounding to nearest, whatever the caller has set.
template <class Body>
void parallel_ranges(const ExtractOptions& options, std::string_view name, std::size_t count,
                     std::size_t grain, const Body& body) {
  std::atomic<std::size_t> done{0};
  std::mutex mutex;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
    const FloatingPointEnvironment environment;
    body(range.begin(), range.end());
    if (!options.progress) return;
    done += range.size();
    if (const std::unique_lock lock(mutex, std::try_to_lock); lock)
      options.progress(name, static_cast<double>(done) / static_cast<double>(count));
  });
}

/// The same with a body for one index.
template <class Body>
void parallel_stage(const ExtractOptions& options, std::string_view name, std::size_t count,
                    std::size_t grain, const Body& body) {
  parallel_ranges(options, name, count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) body(i);
  });
}

/// The same with a body for at most `block` indices in a row.
template <class Body>
void parallel_blocks(const ExtractOptions& options, std::string_view name, std::size_t count,
                     std::size_t grain, std::size_t block, const Body& body) {
  parallel_ranges(options, name, count, grain, [&](std::size_t begin, std::size_t end) {
    for (; begin != end; begin += std::min(block, end - begin))
      body(begin, begin + std::min(block, end - begin));
  });
}

/// Measures the stages of a run.
class Stopwatch {
 public:
  /// Seconds since the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace tensortopo
