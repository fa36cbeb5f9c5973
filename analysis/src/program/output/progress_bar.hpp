// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <deque>
#include <string>
#include <string_view>

#include "tensortopo/analysis/progress.hpp"

namespace tensortopo {

/// How long the rest of a work will take, at its pace in the last half of the time so far.
class TimeLeft {
 public:
  /// "", or " (3 min left)": nothing is said of short runs and of small parts.
  /// @param fraction  of the work that is done, after so many seconds; neither falls
  std::string after(double fraction, double seconds);

 private:
  struct Moment {
    double fraction = 0, seconds = 0;
  };
  std::deque<Moment> past_{Moment{}};
};

/// Says on standard error what goes on, how much of it is done, and how long it will take about.
///
/// On a terminal this is one line, erased at the end. Elsewhere (a file, a pipe, a terminal without
/// escapes, TERM=dumb) it is a line a minute, so that only long runs are heard of.
class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// To pass on; empty if silent. Must not outlive the bar.
  Progress callback();
  /// Takes the line away, so that other words can stand there.
  void erase();

 private:
  using Clock = std::chrono::steady_clock;

  void show(std::string_view stage, double fraction);
  void show_line(std::string_view stage, double fraction, double seconds);

  enum class Kind { silent, bar, lines };
  Kind kind_;
  bool shown_ = false;
  std::string stage_;
  bool full_ = false;  ///< the stage has been shown as done
  Clock::time_point start_ = Clock::now(), last_{};
  std::chrono::seconds next_line_;
  TimeLeft left_;
};

}  // namespace tensortopo
