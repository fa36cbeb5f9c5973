// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace tensortopo {

/// Divides a time among parts of known weights, one after the other. What a part leaves over, or
/// takes too much, is shared by those that follow.
class TimeBudget {
 public:
  /// @param seconds  from here on, for all parts
  /// @param weights  the sum of those of all parts
  TimeBudget(double seconds, double weights) : seconds_(seconds), weights_(weights) {}

  /// The seconds of the next part; 0 if none are left.
  double take(double weight);

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_ = Clock::now();
  double seconds_, weights_;
};

}  // namespace tensortopo
