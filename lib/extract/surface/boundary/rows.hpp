// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "extract/run/parallel_stage.hpp"

namespace tensortopo {

/// So many lists are made together, and lie in one array.
inline constexpr std::size_t kRowsInBlock = 256;

/// Lists of different lengths, one after the other in one array; a list may be unknown, which is
/// not the same as empty.
template <class Value>
class RowBlock {
 public:
  /// @param list  is moved from; nothing for an unknown one
  void append(std::optional<std::vector<Value>>&& list) {
    append(list ? std::span<Value>(*list) : std::span<Value>(), list.has_value());
  }
  void append(std::span<Value> moved_from, bool is_known) {
    values_.insert(values_.end(), std::move_iterator(moved_from.begin()),
                   std::move_iterator(moved_from.end()));
    end_list(is_known);
  }
  /// A list of one value.
  void append_one(Value&& value) {
    values_.push_back(std::move(value));
    end_list(true);
  }
  void append_empty() { end_list(true); }

  /// Of lists, and of the values in all of them.
  std::size_t size() const { return known_.size(); }
  std::size_t count() const { return values_.size(); }
  bool is_known(std::size_t i) const { return known_[i] != 0; }
  /// Where a list begins among the values.
  std::size_t first(std::size_t i) const { return i == 0 ? 0 : ends_[i - 1]; }
  std::span<const Value> operator[](std::size_t i) const {
    return std::span(values_).subspan(first(i), ends_[i] - first(i));
  }
  std::span<Value> operator[](std::size_t i) {
    return std::span(values_).subspan(first(i), ends_[i] - first(i));
  }

 private:
  void end_list(bool is_known) {
    ends_.push_back(static_cast<std::uint32_t>(values_.size()));
    known_.push_back(is_known);
  }

  std::vector<std::uint32_t> ends_;  ///< of the lists
  std::vector<char> known_;
  std::vector<Value> values_;
};

/// Lists in blocks, so that threads make them without moving what others have made.
template <class Value>
class Rows {
 public:
  Rows() = default;
  /// @pre each block but the last has `kRowsInBlock` lists
  explicit Rows(std::vector<RowBlock<Value>>&& blocks) : blocks_(std::move(blocks)) {
    for (const auto& block : blocks_) {
      first_.push_back(count_);
      count_ += block.count();
      size_ += block.size();
    }
  }

  /// @param here, there  lists are moved out of both
  /// @param from_there   of each list the one of `there` to take; -1: the list of the same place
  ///                     `here`
  Rows(Rows&& here, Rows&& there, std::span<const std::int32_t> from_there)
      : Rows(merged(here, there, from_there)) {}

  /// Of lists, and of the values in all of them.
  std::size_t size() const { return size_; }
  std::size_t count() const { return count_; }
  bool is_known(std::size_t i) const {
    return blocks_[i / kRowsInBlock].is_known(i % kRowsInBlock);
  }
  std::span<const Value> operator[](std::size_t i) const {
    return blocks_[i / kRowsInBlock][i % kRowsInBlock];
  }
  std::span<Value> operator[](std::size_t i) { return blocks_[i / kRowsInBlock][i % kRowsInBlock]; }
  /// Where a list begins among all values.
  std::size_t first(std::size_t i) const {
    return first_[i / kRowsInBlock] + blocks_[i / kRowsInBlock].first(i % kRowsInBlock);
  }

 private:
  static std::vector<RowBlock<Value>> merged(Rows& here, Rows& there,
                                             std::span<const std::int32_t> from_there) {
    std::vector<RowBlock<Value>> blocks((from_there.size() + kRowsInBlock - 1) / kRowsInBlock);
    for (std::size_t i = 0; i < from_there.size(); ++i) {
      Rows& rows = from_there[i] < 0 ? here : there;
      const std::size_t k = from_there[i] < 0 ? i : static_cast<std::size_t>(from_there[i]);
      blocks[i / kRowsInBlock].append(rows[k], rows.is_known(k));
    }
    return blocks;
  }

  std::vector<RowBlock<Value>> blocks_;
  std::vector<std::size_t> first_;  ///< values before each block
  std::size_t size_ = 0, count_ = 0;
};

/// Makes lists in parallel. The result does not depend on the number of threads.
/// @param at_once  `make` is called for at most so many lists in a row
/// @param make     appends the lists from one to before another to a block
template <class Value, class Make>
Rows<Value> make_rows(const ExtractOptions& options, std::string_view name, std::size_t count,
                      std::size_t at_once, const Make& make) {
  std::vector<RowBlock<Value>> blocks((count + kRowsInBlock - 1) / kRowsInBlock);
  parallel_stage(options, name, blocks.size(), 1, [&](std::size_t b) {
    const std::size_t end = std::min(count, (b + 1) * kRowsInBlock);
    for (std::size_t i = b * kRowsInBlock; i < end; i += at_once)
      make(i, std::min(end, i + at_once), blocks[b]);
  });
  return Rows<Value>(std::move(blocks));
}

}  // namespace tensortopo
