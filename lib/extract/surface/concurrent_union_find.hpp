// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace tensortopo {

/// `UnionFind` for several threads at once, without locks. The classes, and their least members by
/// which they are named, do not depend on the order of unions.
class ConcurrentUnionFind {
 public:
  /// @param size  how many there are, each in a class of its own
  explicit ConcurrentUnionFind(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  /// The least member of the class of `i`, once all unions have been made.
  std::uint32_t find(std::uint32_t i) {
    // A parent is less than its child, so this ends, whatever others change meanwhile.
    for (;;) {
      auto parent = at(i).load(std::memory_order_relaxed);
      if (parent == i) return i;
      const auto next = at(parent).load(std::memory_order_relaxed);
      if (next != parent) at(i).compare_exchange_weak(parent, next, std::memory_order_relaxed);
      i = next;
    }
  }

  void unite(std::uint32_t i, std::uint32_t j) {
    for (;;) {
      i = find(i), j = find(j);
      if (i == j) return;
      if (i < j) std::swap(i, j);
      auto root = i;  // still, if nobody else gave it a parent
      if (at(i).compare_exchange_strong(root, j, std::memory_order_relaxed)) return;
    }
  }

 private:
  std::atomic_ref<std::uint32_t> at(std::uint32_t i) { return std::atomic_ref(parent_[i]); }

  std::vector<std::uint32_t> parent_;
};

}  // namespace tensortopo
