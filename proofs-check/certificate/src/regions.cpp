// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "regions.hpp"

namespace certificate {

std::array<mpz_class, 3> weights_in(const Refinement::Point& point, unsigned face) {
  std::array<mpz_class, 3> result;
  for (std::size_t i = 0, n = 0; i < 4; ++i)
    if ((face >> i & 1U) != 0) result[n++] = point.weights[i];
  return result;
}

/// In a tile, an edge between points of one side does not meet the level: they are in one region.
FaceRegions::FaceRegions(const Refinement& r, unsigned face)
    : refinement_(r), face_(face), regions_(r.points().size()) {
  for (const Refinement::Cell& cell : r.cells()) {
    if (cell.cut) continue;
    for_subsets(r.corners(), 3, [&](const auto& members) {
      std::array<Refinement::Id, 3> tile;
      for (std::size_t i = 0; i < 3; ++i) tile[i] = cell.points[members[i]];
      for (const Refinement::Id id : tile)
        if ((r.points()[id].support & ~face) != 0) return;
      tiles_.push_back(tile);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (r.points()[tile[i]].above == r.points()[tile[j]].above)
            regions_.join(tile[i], tile[j]);
    });
  }
}

namespace {

int side(const std::array<mpz_class, 3>& a, const std::array<mpz_class, 3>& b,
         const std::array<mpz_class, 3>& c) {
  return sgn(mpz_class(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0])));
}

}  // namespace

std::optional<std::size_t> FaceRegions::find(const std::array<mpz_class, 3>& weights, bool above) {
  for (const auto& tile : tiles_) {
    std::array<std::array<mpz_class, 3>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = weights_in(refinement_.points()[tile[i]], face_);
    const int turn = side(corners[0], corners[1], corners[2]);
    if (side(weights, corners[1], corners[2]) * turn < 0 ||
        side(corners[0], weights, corners[2]) * turn < 0 ||
        side(corners[0], corners[1], weights) * turn < 0)
      continue;
    for (const Refinement::Id id : tile)
      if (refinement_.points()[id].above == above) return regions_.find(id);
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace certificate
