// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "extract/patch/triangle_pair.hpp"

namespace tensortopo {

/// Boxes in a binary tree, halved along the longest axis again and again. It is built in parallel,
/// and the same whatever the number of threads.
class BoxTree {
 public:
  /// @pre no coordinate is NaN
  explicit BoxTree(std::span<const AxisBox> boxes);

  std::size_t size() const { return order_.size(); }

  /// Calls `f` for the box of a rank and each box of a higher rank that meets it, by their places in
  /// the list given, until a call returns true. All ranks together give each pair once.
  /// @return whether a call returned true
  template <class F>
  bool any_meeting(std::size_t rank, const F& f) const {
    return any_meeting(1, 0, size(), rank, f);
  }

 private:
  static constexpr std::size_t kLeaf = 8;

  void build(std::size_t node, std::size_t begin, std::size_t end, std::span<const AxisBox> boxes);

  template <class F>
  bool any_meeting(std::size_t node, std::size_t begin, std::size_t end, std::size_t rank,
                   const F& f) const {
    if (end <= rank + 1 || !boxes_meet(nodes_[node], boxes_[rank])) return false;
    if (end - begin > kLeaf) {
      const std::size_t middle = begin + (end - begin) / 2;
      return any_meeting(2 * node, begin, middle, rank, f) ||
             any_meeting(2 * node + 1, middle, end, rank, f);
    }
    for (std::size_t other = std::max(begin, rank + 1); other < end; ++other)
      if (boxes_meet(boxes_[other], boxes_[rank]) && f(order_[rank], order_[other])) return true;
    return false;
  }

  std::vector<std::uint32_t> order_;  ///< places of the boxes, by rank
  std::vector<AxisBox> boxes_;        ///< by rank
  std::vector<AxisBox> nodes_;        ///< around both parts 2 n and 2 n + 1 of node n; the root is 1
};

inline BoxTree::BoxTree(std::span<const AxisBox> boxes) : order_(boxes.size()), boxes_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::size_t nodes = 2;
  for (std::size_t part = boxes.size(); part > kLeaf; part -= part / 2) nodes *= 2;
  nodes_.resize(nodes);
  if (!boxes.empty()) build(1, 0, boxes.size(), boxes);
}

inline void BoxTree::build(std::size_t node, std::size_t begin, std::size_t end,
                    std::span<const AxisBox> boxes) {
  constexpr std::size_t kInParallel = 4096;
  AxisBox around = boxes[order_[begin]];
  for (std::size_t i = begin + 1; i < end; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      around.low[k] = std::min(around.low[k], boxes[order_[i]].low[k]);
      around.high[k] = std::max(around.high[k], boxes[order_[i]].high[k]);
    }
  nodes_[node] = around;
  if (end - begin <= kLeaf) {
    for (std::size_t i = begin; i < end; ++i) boxes_[i] = boxes[order_[i]];
    return;
  }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (around.high[k] - around.low[k] > around.high[axis] - around.low[axis]) axis = k;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(boxes[i].low[axis], i) < std::pair(boxes[j].low[axis], j);
  });
  const auto first = [&] { build(2 * node, begin, middle, boxes); };
  const auto second = [&] { build(2 * node + 1, middle, end, boxes); };
  if (end - begin > kInParallel) return tbb::parallel_invoke(first, second);
  first();
  second();
}

}  // namespace tensortopo
