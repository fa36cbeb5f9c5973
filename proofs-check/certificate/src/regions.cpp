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

namespace {

template <class A, class B, class C>
int side(const A& a, const B& b, const C& c) {
  return sgn(mpz_class(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0])));
}

}  // namespace

std::optional<std::size_t> FaceRegions::find(const std::array<mpz_class, 3>& weights, bool above) {
  const auto& points = refinement_.points();
  for (const Refinement::Cell& cell : refinement_.cells()) {
    if (cell.cut) continue;
    const std::array<Refinement::Id, 3> tile{cell.points[0], cell.points[1], cell.points[2]};
    const auto &a = points[tile[0]].weights, &b = points[tile[1]].weights,
               &c = points[tile[2]].weights;
    const int turn = side(a, b, c);
    if (side(weights, b, c) * turn < 0 || side(a, weights, c) * turn < 0 ||
        side(a, b, weights) * turn < 0)
      continue;
    for (const Refinement::Id id : tile)
      if (points[id].above == above) return regions_.find(id);
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace certificate
