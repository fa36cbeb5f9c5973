// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "tensortopo/analysis/progress.hpp"

namespace tensortopo {

/// One line on standard error that says what goes on; erased at the end.
/// Silent unless standard error is a terminal.
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
  void show(std::string_view stage, double fraction);

  bool shown_ = false;
  bool active_;
  std::string stage_;
  bool full_ = false;  ///< the stage has been shown as done
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace tensortopo
