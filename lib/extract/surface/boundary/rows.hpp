// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "extract/run/parallel_stage.hpp"

namespace tensortopo {

/// Lists of different lengths, one after the other in arrays of `kBlock` lists each, so that
/// threads fill arrays of their own. A list may be unknown, which is not the same as empty.
template <class Value>
class Rows {
 public:
  static constexpr std::size_t kBlock = 256;

  Rows() = default;
  /// Lists that nobody has added yet.
  explicit Rows(std::size_t size)
      : blocks_((size + kBlock - 1) / kBlock), known_(size, 0), end_(size, 0) {}

  /// Adds the lists block by block, in parallel.
  /// @param add  called with the first list of some of a block, at most `step`, and the one after
  ///             their last: adds these, in order, by `add`, `add_one` or `add_unknown`
  template <class Add>
  void fill(const ExtractOptions& options, std::string_view stage, std::size_t step,
            const Add& add) {
    parallel_stage(options, stage, blocks_.size(), 1, [&](std::size_t b) {
      const std::size_t end = std::min(size(), (b + 1) * kBlock);
      auto& values = blocks_[b].values;
      values.reserve(kBlock);
      for (std::size_t i = b * kBlock; i < end; i += step) add(i, std::min(i + step, end));
      values.shrink_to_fit();
    });
    number();
  }

  /// @param i  the first list of its block that has not been added
  void add(std::size_t i, std::vector<Value>&& list) {
    auto& values = blocks_[i / kBlock].values;
    values.insert(values.end(), std::make_move_iterator(list.begin()),
                  std::make_move_iterator(list.end()));
    close(i, true);
  }
  void add_one(std::size_t i, Value value) {
    blocks_[i / kBlock].values.push_back(std::move(value));
    close(i, true);
  }
  void add_unknown(std::size_t i) { close(i, false); }

  /// @param here, there  lists are moved out of both
  /// @param from_there   of each list the one of `there` to take; -1: the list of the same place
  ///                     `here`
  Rows(Rows&& here, Rows&& there, std::span<const std::int32_t> from_there)
      : Rows(from_there.size()) {
    for (std::size_t i = 0; i < size(); ++i) {
      const bool is_there = from_there[i] >= 0;
      Rows& rows = is_there ? there : here;
      const std::size_t k = is_there ? static_cast<std::size_t>(from_there[i]) : i;
      for (Value& value : rows[k]) blocks_[i / kBlock].values.push_back(std::move(value));
      close(i, rows.is_known(k));
    }
    number();
  }

  /// Gives back the memory of all lists, in parallel.
  void clear(const ExtractOptions& options, std::string_view stage) {
    parallel_stage(options, stage, blocks_.size(), 1,
                   [&](std::size_t b) { std::vector<Value>().swap(blocks_[b].values); });
    *this = Rows();
  }

  std::size_t size() const { return known_.size(); }
  bool is_known(std::size_t i) const { return known_[i] != 0; }
  std::span<const Value> operator[](std::size_t i) const {
    return std::span(blocks_[i / kBlock].values).subspan(begin_of(i), end_[i] - begin_of(i));
  }
  std::span<Value> operator[](std::size_t i) {
    return std::span(blocks_[i / kBlock].values).subspan(begin_of(i), end_[i] - begin_of(i));
  }
  /// Where a list begins among all values.
  std::size_t first(std::size_t i) const { return blocks_[i / kBlock].first + begin_of(i); }
  /// How many values there are in all lists.
  std::size_t count() const { return count_; }

 private:
  struct Block {
    std::size_t first = 0;  ///< of its values among all
    std::vector<Value> values;
  };

  /// Where a list begins in its block.
  std::uint32_t begin_of(std::size_t i) const { return i % kBlock == 0 ? 0 : end_[i - 1]; }

  void close(std::size_t i, bool is_known) {
    known_[i] = is_known;
    end_[i] = static_cast<std::uint32_t>(blocks_[i / kBlock].values.size());
  }

  void number() {
    count_ = 0;
    for (Block& block : blocks_) {
      block.first = count_;
      count_ += block.values.size();
    }
  }

  std::vector<Block> blocks_;
  std::vector<char> known_;
  std::vector<std::uint32_t> end_;  ///< of each list in its block
  std::size_t count_ = 0;
};

}  // namespace tensortopo
