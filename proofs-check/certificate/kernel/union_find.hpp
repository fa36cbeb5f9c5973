// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace certificate {

/// Classes of 0, 1, ...; the smallest member stands for its class.
class UnionFind {
 public:
  std::size_t find(std::size_t i) {
    while (i >= parent_.size()) parent_.push_back(parent_.size());
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = find(i), j = find(j);
    (i < j ? parent_[j] : parent_[i]) = i < j ? i : j;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// Classes of any numbers, few of them: one stands for each class.
class SparseUnionFind {
 public:
  std::size_t find(std::size_t member) {
    return classes_.find(numbers_.try_emplace(member, numbers_.size()).first->second);
  }
  void join(std::size_t a, std::size_t b) { classes_.join(find(a), find(b)); }

 private:
  std::unordered_map<std::size_t, std::size_t> numbers_;
  UnionFind classes_;
};

}  // namespace certificate
