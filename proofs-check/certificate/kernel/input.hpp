// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace certificate {

/// A mesh with a tensor at each point (XX YY ZZ XY YZ XZ): tetrahedra in ascending vertices, and
/// their positions among all cells of a file, ascending.
struct Input {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 6>> tensors;
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<std::uint64_t> cells;

  /// Which tetrahedron is that cell of the file? kNone if none is.
  std::size_t tet_at(std::uint64_t cell) const {
    const auto place = std::lower_bound(cells.begin(), cells.end(), cell);
    return place == cells.end() || *place != cell
               ? kNone
               : static_cast<std::size_t>(place - cells.begin());
  }
};

/// Calls f(0), ..., f(count - 1) in any order, perhaps some at the same time; `what` is for people.
using ForAll = std::function<void(std::size_t count, const std::function<void(std::size_t)>& f,
                                  const char* what)>;

}  // namespace certificate
