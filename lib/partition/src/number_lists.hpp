// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Lists of lists as plain numbers.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tensortopo {

/// Writes numbers, and lists after their lengths.
template <class Number>
class ListWriter {
 public:
  void number(Number n) { made.push_back(n); }
  template <class List, class F>
  void list(const List& items, const F& write) {
    number(static_cast<Number>(items.size()));
    for (const auto& item : items) write(item);
  }

  std::vector<Number> made;  ///< so far
};

/// Reads them. What is no such list throws std::invalid_argument; memory is in proportion to the
/// numbers.
template <class Number>
class ListReader {
 public:
  /// @param what  what the numbers are, for messages
  ListReader(std::span<const Number> numbers, const char* what) : numbers_(numbers), what_(what) {}

  [[noreturn]] void refuse() const {
    throw std::invalid_argument("pieces: the numbers of a piece's " + std::string(what_) +
                                " are not what they should be");
  }
  Number number() {
    if (at_ == numbers_.size()) refuse();
    return numbers_[at_++];
  }
  Number below(std::size_t count) {
    const Number n = number();
    if (n < 0 || static_cast<std::size_t>(n) >= count) refuse();
    return n;
  }
  /// @param read  reads one item, of at least one number
  template <class List, class F>
  void list(List& items, const F& read) {
    for (Number left = below(numbers_.size()); left > 0; --left) items.push_back(read());
  }
  void require_end() const {
    if (at_ != numbers_.size()) refuse();
  }

 private:
  std::span<const Number> numbers_;
  const char* what_;
  std::size_t at_ = 0;
};

}  // namespace tensortopo
