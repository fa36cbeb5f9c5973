// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tensortopo {

/// Lists of different lengths, one after the other in one array; a list may be unknown, which is
/// not the same as empty.
template <class Value>
class Rows {
 public:
  Rows() = default;
  /// @param lists  in order; nothing for an unknown one. They are moved from.
  explicit Rows(std::vector<std::optional<std::vector<Value>>>&& lists) {
    std::size_t count = 0;
    for (const auto& list : lists) count += list ? list->size() : 0;
    begin_.reserve(lists.size() + 1);
    known_.reserve(lists.size());
    values_.reserve(count);
    for (auto& list : lists) {
      begin_.push_back(values_.size());
      known_.push_back(list.has_value());
      if (list)
        values_.insert(values_.end(), std::make_move_iterator(list->begin()),
                       std::make_move_iterator(list->end()));
      list.reset();
    }
    begin_.push_back(values_.size());
  }

  /// @param here, there  lists are moved out of both
  /// @param from_there   of each list the one of `there` to take; -1: the list of the same place
  ///                     `here`
  Rows(Rows&& here, Rows&& there, std::span<const std::int32_t> from_there) {
    const auto source = [&](std::size_t i) {
      return from_there[i] < 0
                 ? std::pair<Rows*, std::size_t>{&here, i}
                 : std::pair<Rows*, std::size_t>{&there, static_cast<std::size_t>(from_there[i])};
    };
    std::size_t count = 0;
    for (std::size_t i = 0; i < from_there.size(); ++i) {
      const auto [rows, k] = source(i);
      begin_.push_back(count);
      known_.push_back(rows->known_[k]);
      count += (*rows)[k].size();
    }
    begin_.push_back(count);
    values_.reserve(count);
    for (std::size_t i = 0; i < from_there.size(); ++i) {
      const auto [rows, k] = source(i);
      for (Value& value : (*rows)[k]) values_.push_back(std::move(value));
    }
  }

  std::size_t size() const { return known_.size(); }
  bool is_known(std::size_t i) const { return known_[i] != 0; }
  std::span<const Value> operator[](std::size_t i) const {
    return std::span(values_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }
  std::span<Value> operator[](std::size_t i) {
    return std::span(values_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }
  /// Where a list begins among all values.
  std::size_t first(std::size_t i) const { return begin_[i]; }
  /// All values, of all lists.
  std::span<const Value> values() const { return values_; }

 private:
  std::vector<std::size_t> begin_;  ///< of each list, and the end of the last
  std::vector<char> known_;
  std::vector<Value> values_;
};

}  // namespace tensortopo
