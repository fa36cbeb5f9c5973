// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "regions.hpp"

namespace certificate {

/// In a cell, an edge between points of one side does not meet the level: they are in one region.
FaceRegions::FaceRegions(const Refinement& r) : refinement_(r), regions_(r.points().size()) {
  for (const Refinement::Cell& cell : r.cells()) {
    if (cell.cut) continue;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (r.points()[cell.points[i]].above == r.points()[cell.points[j]].above)
          regions_.join(cell.points[i], cell.points[j]);
  }
}

std::optional<std::size_t> FaceRegions::find(const std::array<mpz_class, 3>& weights, bool above) {
  const auto& points = refinement_.points();
  for (const Refinement::Cell& cell : refinement_.cells()) {
    if (cell.cut) continue;
    const std::array<Refinement::Id, 3> tile{cell.points[0], cell.points[1], cell.points[2]};
    const auto &a = points[tile[0]].weights, &b = points[tile[1]].weights,
               &c = points[tile[2]].weights;
    const int turn = side_of(a, b, c);
    if (side_of(weights, b, c) * turn < 0 || side_of(a, weights, c) * turn < 0 ||
        side_of(a, b, weights) * turn < 0)
      continue;
    for (const Refinement::Id id : tile)
      if (points[id].above == above) return regions_.find(id);
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace certificate
