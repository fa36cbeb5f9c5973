// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What ranks say of the parts of surfaces or curves, one for each mode.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ranks.hpp"
#include "tensortopo/modes/mode_extractor.hpp"
#include "whole_mesh.hpp"

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

/// What the seams of all ranks say of one mode.
template <class Joined>
struct JoinedPart {
  double mode = 0;
  Joined joined;
};

/// Joins the seams of each mode's parts. All ranks call it, and it throws std::exception on all or
/// none.
/// @tparam Seam      of surfaces or of curves
/// @param write      write(numbers): writes this rank's seams by `write_part`, and gives what is its
///                   own of each
/// @param read       makes a seam of its numbers
/// @param join       join(seams, mode)
/// @param component  of the triangles or lines of all modes: the rank's own get theirs in the whole
template <class Seam, class Write, class Read, class Join>
auto join_parts(const Ranks& ranks, const WholeMesh& whole, const Write& write, const Read& read,
                const Join& join, std::vector<SurfaceMesh::Index>& component) {
  std::vector<std::int64_t> message;
  std::vector<OwnCells> own;
  ranks.together([&] { own = write(message); });
  std::vector<std::vector<SentPart<Seam>>> sent;
  std::size_t modes = 0;
  for (const auto& numbers : ranks.gather(message)) {
    sent.push_back(read_parts<Seam>(numbers, read));
    modes = std::max(modes, sent.back().size());
  }
  using Joined = decltype(join(std::vector<Seam>{}, 0.0));
  std::vector<JoinedPart<Joined>> parts;
  SurfaceMesh::Index first = 0;  // component of the mode
  for (std::size_t m = 0; m < modes; ++m) {
    double mode = 0;
    std::vector<Seam> seams(sent.size());
    for (std::size_t r = 0; r < sent.size(); ++r) {
      if (!sent[r].empty()) {  // else it has no cells
        seams[r] = std::move(sent[r][m].seam);
        mode = sent[r][m].mode;
      }
      seams[r].owned_ids = whole.owned_ids[r];
      seams[r].whole_tets = whole.tets;
    }
    const Joined& joined =
        parts.emplace_back(JoinedPart<Joined>{mode, join(std::move(seams), mode)}).joined;
    if (m < own.size()) {
      const auto& numbers = joined.numbers[as_size(ranks.own())];
      for (std::size_t i = 0; i < own[m].cells.size(); ++i)
        component[own[m].cells[i]] = first + numbers[as_size(own[m].component[i])];
    }
    first += static_cast<SurfaceMesh::Index>(joined.components.size());
  }
  return parts;
}

}  // namespace tensortopo::filters
