// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tensortopo {

/// Classes of the numbers from 0 that may be united. Each is named by its least member, so what
/// comes of them does not depend on the order of unions.
class UnionFind {
 public:
  /// @param size  how many there are, each in a class of its own
  explicit UnionFind(std::size_t size = 0) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  /// How many elements there are.
  std::size_t size() const { return parent_.size(); }

  /// One more, in a class of its own.
  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    return parent_.back();
  }

  /// The least member of the class of `i`.
  /// @pre i < size()
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// @return whether these were two classes
  /// @pre i < size() and j < size()
  bool unite(std::uint32_t i, std::uint32_t j) {
    i = find(i), j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
    return i != j;
  }

  /// The number of classes.
  std::size_t count() const {
    std::size_t classes = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i)
      if (parent_[i] == i) ++classes;
    return classes;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace tensortopo
