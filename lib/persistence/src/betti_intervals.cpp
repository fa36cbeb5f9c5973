// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "betti_intervals.hpp"

#include <algorithm>
#include <cstddef>

namespace tensortopo::persistence {
namespace {

using Betti = std::array<long, 3>;

Betti sum(const Betti& a, const Betti& b, long factor) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

class Intervals {
 public:
  explicit Intervals(const BettiChanges& changes) : given_(changes), sorted_(changes.changes) {
    std::stable_sort(
        sorted_.begin(), sorted_.end(),
        [](const BettiChange& a, const BettiChange& b) { return a.mode.low < b.mode.low; });
    for (const BettiChange& change : sorted_) all_ = sum(all_, change.by, 1);
    for (std::size_t i = 0; i < 2; ++i)
      for (const ModeRange& mode : changes.open[i]) {
        lowest_open_[i] = std::min(lowest_open_[i], mode.low);
        highest_open_[i] = std::max(highest_open_[i], mode.high);
      }
  }

  std::vector<BettiInterval> run() {
    for (const BettiChange& change : sorted_) {
      end_at(change.mode.low);
      below_ = sum(below_, change.by, 1);
      begin_ = std::max(begin_, change.mode.high);
    }
    end_at(1);
    return std::move(intervals_);
  }

 private:
  void end_at(double high) {
    if (!(begin_ < high)) return;
    BettiInterval interval;
    interval.low = begin_;
    interval.high = high;
    const Betti above = sum(all_, below_, -1);
    const Betti from_start = given_.falls ? above : below_;
    const Betti from_end = sum(given_.mesh, given_.falls ? below_ : above, -1);
    std::array<bool, 2> is_known_before{}, is_known_after{};
    for (std::size_t i = 0; i < 2; ++i) {
      is_known_before[i] = given_.falls ? highest_open_[i] <= begin_ : lowest_open_[i] >= high;
      is_known_after[i] = given_.falls ? lowest_open_[i] >= high : highest_open_[i] <= begin_;
    }
    interval.betti = {from_start[0], is_known_before[1] ? from_start[1] : from_end[1], from_end[2]};
    const bool has_components = given_.is_known && is_known_before[0];
    const bool has_voids = given_.is_known && is_known_after[1];
    interval.is_certain = {has_components,
                           has_components && has_voids && (is_known_before[1] || is_known_after[0]),
                           has_voids};
    // Equal ones next to each other are one.
    if (!intervals_.empty() && intervals_.back().high >= begin_ &&
        intervals_.back().betti == interval.betti &&
        intervals_.back().is_certain == interval.is_certain)
      intervals_.back().high = high;
    else
      intervals_.push_back(interval);
  }

  const BettiChanges& given_;
  std::vector<BettiChange> sorted_;
  Betti all_{}, below_{};
  std::array<double, 2> lowest_open_{2, 2}, highest_open_{-2, -2};
  double begin_ = -1;
  std::vector<BettiInterval> intervals_;
};

}  // namespace

std::vector<BettiInterval> betti_intervals(const BettiChanges& changes) {
  return Intervals(changes).run();
}

}  // namespace tensortopo::persistence
