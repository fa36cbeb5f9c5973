// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <string_view>

#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

/// Runs a body for each index in parallel, and reports how far it is. The bodies write to places
/// of their own, so the result does not depend on the number of threads. Error bounds hold for
/// rounding to nearest, whatever the caller has set.
template <class Body>
void parallel_stage(const ExtractOptions& options, std::string_view name, std::size_t count,
                    std::size_t grain, const Body& body) {
  std::atomic<std::size_t> done{0};
  std::mutex mutex;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
    const FloatingPointEnvironment environment;
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
    if (!options.progress) return;
    done += range.size();
    if (const std::unique_lock lock(mutex, std::try_to_lock); lock)
      options.progress(name, static_cast<double>(done) / static_cast<double>(count));
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
