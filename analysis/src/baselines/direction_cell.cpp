// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "baselines/direction_cell.hpp"

#include <algorithm>
#include <cmath>

namespace tensortopo::baselines {

namespace {

using Vector = Vector3<double>;

constexpr std::array<std::array<double, 2>, 10> kWhere{// of a cubic's coefficients: shares of b, c
    {{0, 0}, {1. / 3, 0}, {2. / 3, 0}, {1, 0}, {0, 1. / 3}, {1. / 3, 1. / 3}, {2. / 3, 1. / 3},
     {0, 2. / 3}, {1. / 3, 2. / 3}, {0, 1}}};

/// The corner at which the side to be cut next begins: the longest one, next to a singularity in
/// polar coordinates around it. (Similar triangles would never tell directions at it apart.)
std::size_t side_to_cut(const DirectionCell& cell) {
  const auto count = std::count(cell.singular.begin(), cell.singular.end(), true);
  std::array<double, 3> size;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    size[a] = length(cell.corners[b] - cell.corners[a]);
    if (count == 2 && cell.singular[a] && cell.singular[b]) return a;
    if (count == 1 && cell.singular[c]) {
      const Vector p = cell.corners[a] - cell.corners[c], q = cell.corners[b] - cell.corners[c];
      size[a] = length(cross(p, q)) / (length(p) * length(q));
    }
  }
  return static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
}

}  // namespace

std::pair<bool, bool> possible_signs(const DirectionCell& cell) {
  bool positive = true, negative = true;
  for (const Cubic& b : cell.weights) {
    const auto [low, high] = std::minmax_element(b.begin(), b.end());
    positive = positive && *high > 0;
    negative = negative && *low < 0;
  }
  return {positive, negative};
}

bool is_flat(const DirectionCell& cell, double sign, const CellTolerance& tolerance) {
  std::array<Vector, 10> net;
  std::array<double, 10> sums;
  std::array<bool, 10> is_place;
  is_place.fill(true);
  std::array<std::size_t, 3> base = kCorner;
  for (std::size_t a = 0; a < 3; ++a) {
    if (!cell.singular[a]) continue;
    // A quadrilateral: the corner stands for the line between its neighbours in the net.
    is_place[kCorner[a]] = false;
    base[a] = a == 0 ? cubic_place(1, 0) : a == 1 ? cubic_place(2, 0) : cubic_place(0, 2);
  }
  for (std::size_t k = 0; k < 10; ++k) {
    if (!is_place[k]) continue;
    Vector sum{};
    sums[k] = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double b = sign * cell.weights[i][k];
      sums[k] += b;
      sum += b * tolerance.places[i];
    }
    if (!(sums[k] > 0)) return false;
    net[k] = (1 / sums[k]) * sum;
  }
  // The image is in the convex hull of the net.
  const auto normal = cross(net[base[1]] - net[base[0]], net[base[2]] - net[base[0]]);
  const double size = length(normal);
  for (std::size_t k = 0; k < 10; ++k)
    if (is_place[k] &&
        !(std::abs(dot(normal, net[k] - net[base[0]])) <= tolerance.distance * size))
      return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Cubic& b = cell.weights[i];
    const auto [low, high] = std::minmax_element(b.begin(), b.end());
    if (*low >= 0 || *high <= 0) continue;
    for (std::size_t k = 0; k < 10; ++k) {
      if (!is_place[k]) continue;
      const auto& [s, t] = kWhere[k];
      const double line = b[0] + s * (b[3] - b[0]) + t * (b[9] - b[0]);
      if (!(std::abs(b[k] - line) * tolerance.heights[i] <= tolerance.distance * sums[k]))
        return false;
    }
  }
  return true;
}

std::array<DirectionCell, 2> halves(DirectionCell cell) {
  for (std::size_t turn = side_to_cut(cell); turn > 0; --turn) {
    for (Cubic& b : cell.weights) b = turned(b);
    std::rotate(cell.corners.begin(), cell.corners.begin() + 1, cell.corners.end());
    std::rotate(cell.singular.begin(), cell.singular.begin() + 1, cell.singular.end());
  }
  const auto& [a, b, c] = cell.corners;
  const Vector m = 0.5 * (a + b);
  const auto& [a_singular, b_singular, c_singular] = cell.singular;
  DirectionCell first{{c, a, m}, {}, {c_singular, a_singular, false}, cell.depth + 1},
      second{{b, c, m}, {}, {b_singular, c_singular, false}, cell.depth + 1};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto parts = halves(cell.weights[i]);
    first.weights[i] = parts[0];
    second.weights[i] = parts[1];
  }
  return {first, second};
}

}  // namespace tensortopo::baselines
