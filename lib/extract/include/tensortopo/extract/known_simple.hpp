// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tensortopo {

/// What is known of edges or faces of a refinement, by a key made of their vertices: an open hash
/// table that keeps its memory when cleared.
class KnownSimple {
 public:
  /// 1 if simple, -1 if not, 0 if not known yet. Valid until the next call.
  signed char& operator[](std::uint64_t key);
  void clear();

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t round = 0;  ///< in use if it is the current one
    signed char simple = 0;
  };
  std::size_t slot_of(std::uint64_t key) const;
  std::vector<Slot> slots_;
  std::size_t used_ = 0;
  std::uint32_t round_ = 1;
};

}  // namespace tensortopo
