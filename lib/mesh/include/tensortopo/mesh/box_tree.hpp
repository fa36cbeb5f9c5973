// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// A box along the axes.
struct AxisBox {
  std::array<double, 3> low{};   ///< the least coordinates
  std::array<double, 3> high{};  ///< the largest coordinates
};

/// The smallest box that holds two boxes.
inline AxisBox hull(const AxisBox& s, const AxisBox& t) {
  AxisBox both = s;
  for (std::size_t k = 0; k < 3; ++k) {
    both.low[k] = std::min(both.low[k], t.low[k]);
    both.high[k] = std::max(both.high[k], t.high[k]);
  }
  return both;
}

/// The smallest box that holds some points; of no points one that meets nothing.
inline AxisBox box_of(std::span<const Vector3<double>> points) {
  AxisBox box{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  for (const auto& p : points) box = hull(box, {{p.x, p.y, p.z}, {p.x, p.y, p.z}});
  return box;
}

/// Whether two boxes, `low` to `high`, have a point in common.
template <class Box, class OtherBox>
bool boxes_meet(const Box& s, const OtherBox& t) {
  for (std::size_t k = 0; k < 3; ++k)
    if (s.high[k] < t.low[k] || t.high[k] < s.low[k]) return false;
  return true;
}

/// Boxes in a binary tree, halved along the longest axis again and again. It is built in parallel,
/// and the same whatever the number of threads.
class BoxTree {
 public:
  /// @pre no coordinate is NaN
  explicit BoxTree(std::span<const AxisBox> boxes);

  /// How many boxes there are.
  std::size_t size() const { return order_.size(); }

  /// Calls `f` for the box of a rank and each box of a higher rank that meets it, by their places
  /// in the list given, until a call returns true. All ranks together give each pair once.
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
  std::vector<AxisBox> nodes_;  ///< around both parts 2 n and 2 n + 1 of node n; the root is 1
};

/// The pairs of boxes that have a point in common, by their places in the list, in no order.
/// @pre no coordinate is NaN
std::vector<std::array<std::uint32_t, 2>> meeting_boxes(std::span<const AxisBox> boxes);

}  // namespace tensortopo
