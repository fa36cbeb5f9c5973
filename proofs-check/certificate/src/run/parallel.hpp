// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "certificate_check/check_certificate.hpp"
#include "input.hpp"

namespace certificate {

/// Calls f(0), ..., f(count - 1), some at the same time. Throws the first exception.
template <std::size_t kChunk = 16, class F>
void parallel_for(std::size_t count, const F& f, const Progress& progress = {},
                  const char* what = "") {
  std::atomic<std::size_t> next{0};
  std::exception_ptr problem;
  std::mutex mutex;
  const auto work = [&](bool tells) {
    try {
      for (std::size_t i; (i = next.fetch_add(kChunk)) < count;) {
        if (tells && progress) progress(what, static_cast<double>(i) / static_cast<double>(count));
        for (std::size_t j = i; j < std::min(i + kChunk, count); ++j) f(j);
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      problem = std::current_exception();
      next = count;
    }
  };
  const std::size_t threads =
      std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), count / kChunk + 1);
  if (progress && count > 0) progress(what, 0);
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < threads; ++i) others.emplace_back(work, false);
  work(true);
  for (std::thread& thread : others) thread.join();
  if (problem) std::rethrow_exception(problem);
}

/// The same for the kernel.
inline ForAll in_parallel(const Progress& progress) {
  return [progress](std::size_t count, const std::function<void(std::size_t)>& f,
                    const char* what) { parallel_for(count, f, progress, what); };
}

}  // namespace certificate
