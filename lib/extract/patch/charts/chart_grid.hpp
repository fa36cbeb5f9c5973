// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "extract/patch/manifold/manifold_chart.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

/// Calls `visit(vector, point, spacing)` for the vectors of a grid over the real domain that is
/// about even in the chart, and therefore on the surface, next to the boundary included. `point()`
/// is the image, `spacing()` the distance, in the chart, to the nearest neighbours in the grid: few
/// vectors need them.
/// @param is_wanted whether a quadrant of the chart is
/// @param turn about how far the eigenvectors turn from a sample to the next, in radians
template <class Wanted, class Visit>
void visit_grid(const ManifoldChart& chart, double turn, const Wanted& is_wanted,
                const Visit& visit) {
  const bool annulus = chart.quadrants() == 1;
  const auto count = [&](int least, double angle) {
    return std::max(least, static_cast<int>(std::ceil(angle * std::numbers::pi / turn)));
  };
  const int around = count(8, annulus ? 2 : 1.5);
  const int across = count(annulus ? 4 : 2, annulus ? 1 : 0.5);
  for (int quadrant = 0; quadrant < chart.quadrants(); ++quadrant) {
    if (!is_wanted(quadrant)) continue;
    for (int i = 0; i < around; ++i) {
      const auto ray = chart.ray(quadrant, (i + 0.5) / around);
      for (int j = 0; j < across; ++j) {
        const auto point = [&] { return chart.point_at(ray, (j + 0.5) / across); };
        const auto spacing = [&] {
          const auto here = point(), along = chart.point_at(ray, (j + 0.75) / across),
                     beside = chart.point_at(chart.ray(quadrant, (i + 0.75) / around),
                                             (j + 0.5) / across);
          return 4 * std::min(elementary::hypot(along[0] - here[0], along[1] - here[1]),
                              elementary::hypot(beside[0] - here[0], beside[1] - here[1]));
        };
        visit(chart.vector_at(ray, (j + 0.5) / across), point, spacing);
      }
    }
  }
}

}  // namespace tensortopo
