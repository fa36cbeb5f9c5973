// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What ranks say of the parts of surfaces or curves, one for each mode.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/modes/mode_extractor.hpp"

namespace tensortopo::filters {

/// Some values that follow each other.
template <class T>
std::vector<T> some(const std::vector<T>& values, std::size_t first, std::size_t count) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

/// What is a rank's own of a mode's part.
struct OwnCells {
  std::vector<std::size_t> cells;             ///< in owned tetrahedra, among those of all modes
  std::vector<SurfaceMesh::Index> component;  ///< of each, in the seam
};

/// What a rank says of one mode.
/// @tparam Seam  of surfaces or of curves
template <class Seam>
struct SentPart {
  double mode = 0;
  Seam seam;
};

/// @param numbers  of a seam
inline void write_part(const ModeValue& mode, const std::vector<std::int64_t>& numbers,
                       std::vector<std::int64_t>& to) {
  to.push_back(std::bit_cast<std::int64_t>(mode.approx()));
  to.push_back(static_cast<std::int64_t>(numbers.size()));
  to.insert(to.end(), numbers.begin(), numbers.end());
}

/// What `write_part` wrote, part after part.
/// @param read  makes a seam of its numbers
template <class Seam, class Read>
std::vector<SentPart<Seam>> read_parts(std::span<const std::int64_t> numbers, const Read& read) {
  std::vector<SentPart<Seam>> parts;
  while (!numbers.empty()) {
    const auto mode = std::bit_cast<double>(numbers[0]);
    const auto size = static_cast<std::size_t>(numbers[1]);
    parts.push_back({mode, read(numbers.subspan(2, size))});
    numbers = numbers.subspan(2 + size);
  }
  return parts;
}

}  // namespace tensortopo::filters
