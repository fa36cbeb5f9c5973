// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "homology/doubtful_ranges.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace tensortopo::persistence {
namespace {

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

/// Since which mode two maxima have been in one component. Smaller trees hang from larger ones, so
/// ways up are short.
class Meetings {
 public:
  explicit Meetings(std::size_t count)
      : up_(count), size_(count, 1), time_(count, kNever), mode_(count, -2) {
    std::iota(up_.begin(), up_.end(), std::size_t{0});
  }
  /// @param time  grows from call to call
  void join(std::size_t a, std::size_t b, std::size_t time, double mode) {
    a = root_of(a), b = root_of(b);
    if (a == b) return;
    if (size_[a] > size_[b]) std::swap(a, b);
    up_[a] = b;
    time_[a] = time;
    mode_[a] = mode;
    size_[b] += size_[a];
  }
  /// -2 if they are not.
  double since(std::size_t a, std::size_t b) const {
    double mode = 2;
    while (a != b) {
      // The higher a link, the later it was made.
      std::size_t& first = time_[a] <= time_[b] ? a : b;
      if (up_[first] == first) return -2;
      mode = std::min(mode, mode_[first]);
      first = up_[first];
    }
    return mode;
  }

 private:
  std::size_t root_of(std::size_t i) const {
    while (up_[i] != i) i = up_[i];
    return i;
  }
  std::vector<std::size_t> up_, size_, time_;
  std::vector<double> mode_;
};

}  // namespace

std::vector<ModeRange> doubtful_ranges(const MergeTree& tree) {
  Meetings meetings(tree.maxima.size());
  for (std::size_t i = 0; i < tree.merges.size(); ++i) {
    const ModeMerge& merge = tree.merges[i];
    for (std::size_t k = 1; merge.is_proved && k < merge.reached.size(); ++k)
      meetings.join(merge.reached[0], merge.reached[k], i, merge.mode.low);
  }
  std::vector<ModeRange> ranges;
  for (const ModeMerge& merge : tree.merges) {
    if (merge.is_proved) continue;
    double until = -2;
    if (merge.possible && !merge.possible->empty() && !merge.may_be_maximum) {
      until = merge.mode.low;
      for (const std::size_t i : *merge.possible)
        until = std::min(until, meetings.since(merge.possible->front(), i));
    }
    ranges.push_back({until, merge.mode.high});
  }
  return ranges;
}

}  // namespace tensortopo::persistence
