// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tensortopo {

/// A key for an edge of a refinement, whichever its first vertex.
inline std::uint64_t edge_key(std::uint32_t u, std::uint32_t v) {
  return std::uint64_t{std::min(u, v)} << 32 | std::max(u, v);
}

/// The same for a face. Numbers of vertices stay below 2^21: so does the budget of cells.
inline std::uint64_t face_key(std::uint32_t u, std::uint32_t v, std::uint32_t w) {
  const auto least = std::min({u, v, w}), largest = std::max({u, v, w});
  const auto between = u + v + w - least - largest;
  return std::uint64_t{least} << 42 | std::uint64_t{between} << 21 | largest;
}

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
