// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace certificate {

struct Box {
  std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const std::array<double, 3>& p) {
    for (std::size_t k = 0; k < 3; ++k)
      low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  }
  bool meets(const Box& other) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
    return true;
  }
};

/// A binary tree of boxes, cut in halves along the longest side.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (!order_.empty()) build(0, order_.size());
  }

  static constexpr std::size_t kMostParts = 20000;

  /// Calls f(t) for the boxes t that meet box `of` and have larger numbers. False if there are more
  /// than `kMostParts` parts to look at.
  template <class F>
  bool for_meeting(std::size_t of, const F& f) const {
    std::vector<std::size_t> waiting{0};
    for (std::size_t seen = 0; !waiting.empty(); ++seen) {
      if (seen > kMostParts) return false;
      const Node& node = nodes_[waiting.back()];
      waiting.pop_back();
      if (!node.box.meets(boxes_[of])) continue;
      if (node.second != 0) {
        waiting.push_back(node.first), waiting.push_back(node.second);
        continue;
      }
      for (std::size_t i = node.begin; i < node.end; ++i)
        if (order_[i] > of && boxes_[order_[i]].meets(boxes_[of])) ++seen, f(order_[i]);
    }
    return true;
  }

 private:
  struct Node {
    Box box;
    std::size_t begin = 0, end = 0, first = 0, second = 0;
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    constexpr std::size_t kLeaf = 4;
    const std::size_t number = nodes_.size();
    Node node{{}, begin, end, 0, 0};
    for (std::size_t i = begin; i < end; ++i)
      node.box.add(boxes_[order_[i]].low), node.box.add(boxes_[order_[i]].high);
    nodes_.push_back(node);
    if (end - begin <= kLeaf) return number;
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (node.box.high[k] / 2 - node.box.low[k] / 2 >
          node.box.high[axis] / 2 - node.box.low[axis] / 2)
        axis = k;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t s, std::size_t t) {
      const double x = boxes_[s].low[axis] / 2 + boxes_[s].high[axis] / 2,
                   y = boxes_[t].low[axis] / 2 + boxes_[t].high[axis] / 2;
      return x != y ? x < y : s < t;
    });
    const std::size_t first = build(begin, middle), second = build(middle, end);
    nodes_[number].first = first, nodes_[number].second = second;
    return number;
  }

  std::vector<Box> boxes_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace certificate
