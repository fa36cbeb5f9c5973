// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/box_tree.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <numeric>
#include <utility>

namespace tensortopo {

BoxTree::BoxTree(std::span<const AxisBox> boxes) : order_(boxes.size()), boxes_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::size_t nodes = 2;
  for (std::size_t part = boxes.size(); part > kLeaf; part -= part / 2) nodes *= 2;
  nodes_.resize(nodes);
  if (!boxes.empty()) build(1, 0, boxes.size(), boxes);
}

void BoxTree::build(std::size_t node, std::size_t begin, std::size_t end,
                    std::span<const AxisBox> boxes) {
  constexpr std::size_t kInParallel = 4096;
  AxisBox around = boxes[order_[begin]];
  for (std::size_t i = begin + 1; i < end; ++i) around = hull(around, boxes[order_[i]]);
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

std::vector<std::array<std::uint32_t, 2>> meeting_boxes(std::span<const AxisBox> boxes) {
  constexpr std::size_t kPart = 1024;  // boxes that one thread takes at a time
  const BoxTree tree(boxes);
  std::vector<std::vector<std::array<std::uint32_t, 2>>> found(tree.size() / kPart + 1);
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t part) {
    for (std::size_t rank = part * kPart; rank < std::min(tree.size(), (part + 1) * kPart); ++rank)
      tree.any_meeting(rank, [&](std::uint32_t i, std::uint32_t j) {
        found[part].push_back({i, j});
        return false;
      });
  });
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const auto& part : found) pairs.insert(pairs.end(), part.begin(), part.end());
  return pairs;
}

}  // namespace tensortopo
