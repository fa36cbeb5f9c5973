// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "homology/betti_intervals.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace tensortopo::persistence {
namespace {

/// What has changed so far.
struct Sum {
  long components = 0, voids = 0, euler = 0;
  void add(const BettiChange& change) {
    components += change.by[0];
    voids += change.by[2];
    euler += change.by[0] - change.by[1] + change.by[2] + change.euler;
  }
  Sum without(const Sum& other) const {
    return {components - other.components, voids - other.voids, euler - other.euler};
  }
};

/// Whether an interval from a mode on is in a range, for modes that are asked about in order.
class Cover {
 public:
  explicit Cover(std::vector<ModeRange> ranges) : ranges_(std::move(ranges)) {
    std::sort(ranges_.begin(), ranges_.end(),
              [](const ModeRange& a, const ModeRange& b) { return a.low < b.low; });
  }
  bool meets(double low, double high) {
    while (next_ < ranges_.size() && ranges_[next_].low < high)
      end_ = std::max(end_, ranges_[next_++].high);
    return low < end_;
  }

 private:
  std::vector<ModeRange> ranges_;
  std::size_t next_ = 0;
  double end_ = -2;
};

class Intervals {
 public:
  explicit Intervals(const BettiChanges& changes)
      : given_(changes),
        sorted_(changes.changes),
        doubts_{Cover(changes.doubts[0]), Cover(changes.doubts[1])} {
    std::stable_sort(
        sorted_.begin(), sorted_.end(),
        [](const BettiChange& a, const BettiChange& b) { return a.mode.low < b.mode.low; });
    for (const BettiChange& change : sorted_) all_.add(change);
    for (const ModeRange& mode : changes.undecided) {
      lowest_undecided_ = std::min(lowest_undecided_, mode.low);
      highest_undecided_ = std::max(highest_undecided_, mode.high);
    }
  }

  std::vector<BettiInterval> run() {
    for (const BettiChange& change : sorted_) {
      end_at(change.mode.low);
      below_.add(change);
      begin_ = std::max(begin_, change.mode.high);
    }
    end_at(1);
    return std::move(intervals_);
  }

 private:
  /// Of {mode >= m}, or {mode <= m}, between `begin_` and `high`.
  std::optional<long> euler_characteristic(const Sum& before, const Sum& after, double high) const {
    const bool none_below = lowest_undecided_ >= high, none_above = highest_undecided_ <= begin_;
    if (given_.falls ? none_above : none_below) return before.euler;
    if (given_.falls ? none_below : none_above)
      return given_.mesh[0] - given_.mesh[1] + given_.mesh[2] - after.euler;
    return std::nullopt;
  }

  void end_at(double high) {
    if (!(begin_ < high)) return;
    BettiInterval interval;
    interval.low = begin_;
    interval.high = high;
    const Sum above = all_.without(below_);
    const Sum &before = given_.falls ? above : below_, &after = given_.falls ? below_ : above;
    auto& [components, loops, voids] = interval.betti;
    if (given_.is_known && !doubts_[0].meets(begin_, high)) components = before.components;
    if (given_.is_known && !doubts_[1].meets(begin_, high)) voids = given_.mesh[2] - after.voids;
    if (const auto euler = euler_characteristic(before, after, high); euler && components && voids)
      loops = *components + *voids - *euler;
    // Equal ones next to each other are one.
    if (!intervals_.empty() && intervals_.back().high >= begin_ &&
        intervals_.back().betti == interval.betti)
      intervals_.back().high = high;
    else
      intervals_.push_back(interval);
  }

  const BettiChanges& given_;
  std::vector<BettiChange> sorted_;
  std::array<Cover, 2> doubts_;
  Sum all_, below_;
  double lowest_undecided_ = 2, highest_undecided_ = -2;
  double begin_ = -1;
  std::vector<BettiInterval> intervals_;
};

}  // namespace

std::vector<BettiInterval> betti_intervals(const BettiChanges& changes) {
  return Intervals(changes).run();
}

}  // namespace tensortopo::persistence
