// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
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

}  // namespace certificate
