// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace tensortopo {

namespace detail {

/// What a run and whoever watches it share.
struct WatchedState {
  struct Ended {};  ///< ends the work; nobody sees it

  std::mutex mutex;
  std::condition_variable finished;
  bool done = false, fresh = false;
  std::string stage;
  double fraction = 0;
  std::exception_ptr error;
  std::atomic<bool> ended = false;

  void report(std::string_view what, double part) {
    if (ended) throw Ended{};
    const std::lock_guard lock(mutex);
    stage = what, fraction = part, fresh = true;
  }
  void finish(std::exception_ptr thrown) {
    const std::lock_guard lock(mutex);
    error = std::move(thrown), done = true;
    finished.notify_one();
  }
};

}  // namespace detail

/// Runs work in a thread of its own, watched by the calling one: for hosts whose functions only
/// one thread may call, as Python's and VTK's.
///
/// @param work  called with a function to which it reports stages and how much of them is done,
///              from any thread
/// @param look  called by the calling thread some twenty times a second, with whether there is
///              news, and the latest. What it throws ends the work at its next report; when that
///              has ended, it is thrown to the caller.
/// Throws what the work throws.
inline void watched_run(
    const std::function<void(const std::function<void(std::string_view, double)>&)>& work,
    const std::function<void(bool fresh, const std::string& stage, double fraction)>& look) {
  constexpr std::chrono::milliseconds between{50};
  detail::WatchedState state;
  std::exception_ptr ours;
  std::thread worker([&] {
    std::exception_ptr thrown;
    try {
      work([&](std::string_view stage, double fraction) { state.report(stage, fraction); });
    } catch (...) {
      thrown = std::current_exception();
    }
    state.finish(std::move(thrown));
  });
  {
    std::unique_lock lock(state.mutex);
    while (!state.done) {
      state.finished.wait_for(lock, between, [&] { return state.done; });
      if (state.done || ours) continue;
      const bool fresh = std::exchange(state.fresh, false);
      const std::string stage = state.stage;
      const double fraction = state.fraction;
      lock.unlock();
      try {
        look(fresh, stage, fraction);
      } catch (...) {
        ours = std::current_exception();
        state.ended = true;
      }
      lock.lock();
    }
  }
  worker.join();
  if (ours) std::rethrow_exception(ours);
  if (state.error) std::rethrow_exception(state.error);
}

}  // namespace tensortopo
