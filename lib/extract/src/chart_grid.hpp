// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "manifold_chart.hpp"

namespace tensortopo {

/// Calls `visit(sample, spacing)` for the samples of a grid over the real domain that is about even
/// in the chart, and therefore on the surface, next to the boundary included. `spacing()` is the
/// distance, in the chart, to the nearest neighbours in the grid.
/// @param turn about how far the eigenvectors turn from a sample to the next, in radians
template <class Visit>
void visit_grid(const ManifoldChart& chart, double turn, const Visit& visit) {
  const bool annulus = chart.quadrants() == 1;
  const auto count = [&](int least, double angle) {
    return std::max(least, static_cast<int>(std::ceil(angle * std::numbers::pi / turn)));
  };
  const int around = count(8, annulus ? 2 : 1.5);
  const int across = count(annulus ? 4 : 2, annulus ? 1 : 0.5);
  for (int quadrant = 0; quadrant < chart.quadrants(); ++quadrant)
    for (int i = 0; i < around; ++i)
      for (int j = 0; j < across; ++j) {
        const auto at = [&](double di, double dj) {
          return chart.sample(quadrant, (i + di) / around, (j + dj) / across);
        };
        const auto sample = at(0.5, 0.5);
        const auto distance = [&](const ManifoldChart::Sample& quarter) {
          return 4 * std::hypot(quarter.point[0] - sample.point[0],
                                quarter.point[1] - sample.point[1]);
        };
        visit(sample, [&] { return std::min(distance(at(0.75, 0.5)), distance(at(0.5, 0.75))); });
      }
}

}  // namespace tensortopo
