// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/fill/polygon.hpp"

#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace tensortopo {

namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

double diagonal_cost(const PolygonCorner& p, const PolygonCorner& q) {
  if ((p.faces & q.faces) != 0) return kForbidden;
  const auto d = q.position - p.position, turn = cross(p.turned, q.turned);
  return std::sqrt(dot(d, d) + dot(turn, turn));
}

/// Cuts off one corner after the other, always by the shortest diagonal.
std::vector<std::array<int, 3>> cut_corners_off(std::span<const PolygonCorner> corners) {
  const std::size_t n = corners.size();
  std::vector<std::size_t> before(n), after(n);
  for (std::size_t i = 0; i < n; ++i) before[i] = (i + n - 1) % n, after[i] = (i + 1) % n;
  // What was offered for a corner is void once a neighbour has gone.
  using Offer = std::tuple<double, std::size_t, std::size_t, std::size_t>;
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
  const auto offer = [&](std::size_t i) {
    const double cost = diagonal_cost(corners[before[i]], corners[after[i]]);
    if (cost < kForbidden) offers.push({cost, before[i], i, after[i]});
  };
  for (std::size_t i = 0; i < n; ++i) offer(i);
  std::vector<std::array<int, 3>> triangles;
  std::vector<char> gone(n, 0);
  const auto take = [&](std::size_t a, std::size_t b, std::size_t c) {
    triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
  };
  std::size_t left = n;
  while (left > 3 && !offers.empty()) {
    const auto [cost, a, b, c] = offers.top();
    offers.pop();
    if (gone[b] || before[b] != a || after[b] != c) continue;
    take(a, b, c);
    gone[b] = 1, --left;
    after[a] = c, before[c] = a;
    offer(a), offer(c);
  }
  if (left > 3) return {};
  std::size_t a = 0;
  while (gone[a]) ++a;
  take(a, after[a], before[a]);
  return triangles;
}

/// Least cost of the part of a polygon between corners i < j, and the corner that its triangle goes
/// to: tables with `stride` entries in a row.
struct Table {
  std::span<double> cost;
  std::span<std::uint16_t> apex;
  std::size_t stride;
};

std::vector<std::array<int, 3>> cut_shortest(std::span<const PolygonCorner> corners,
                                             const Table& table) {
  const auto n = corners.size();
  const auto at = [&](std::size_t i, std::size_t j) { return i * table.stride + j; };
  for (std::size_t width = 2; width < n; ++width)
    for (std::size_t i = 0; i + width < n; ++i) {
      const std::size_t j = i + width;
      double best = kForbidden;
      std::size_t best_apex = 0;
      for (std::size_t k = i + 1; k < j; ++k) {
        const double c = table.cost[at(i, k)] + table.cost[at(k, j)];
        if (c < best) best = c, best_apex = k;
      }
      const bool side = width + 1 == n;  // the polygon's own side from the last corner to the first
      table.cost[at(i, j)] = best + (side ? 0.0 : diagonal_cost(corners[i], corners[j]));
      table.apex[at(i, j)] = static_cast<std::uint16_t>(best_apex);
    }
  if (!(table.cost[at(0, n - 1)] < kForbidden)) return {};

  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<std::size_t, 2>> parts{{0, n - 1}};
  while (!parts.empty()) {
    const auto [i, j] = parts.back();
    parts.pop_back();
    if (j - i < 2) continue;
    const std::size_t k = table.apex[at(i, j)];
    triangles.push_back({static_cast<int>(i), static_cast<int>(k), static_cast<int>(j)});
    parts.push_back({i, k});
    parts.push_back({k, j});
  }
  return triangles;
}

}  // namespace

std::vector<std::array<int, 3>> cut_polygon(std::span<const PolygonCorner> corners) {
  const auto n = corners.size();
  if (n == 3) {
    // Three corners on one face would make a triangle in that face.
    if ((corners[0].faces & corners[1].faces & corners[2].faces) != 0) return {};
    return {{0, 1, 2}};
  }
  if (n < 3) return {};
  if (n <= kSmallPolygon) {
    std::array<double, kSmallPolygon * kSmallPolygon> cost{};
    std::array<std::uint16_t, kSmallPolygon * kSmallPolygon> apex{};
    return cut_shortest(corners, {cost, apex, kSmallPolygon});
  }
  if (n > kLargestShortest) return cut_corners_off(corners);
  std::vector<double> cost(n * n, 0.0);
  std::vector<std::uint16_t> apex(n * n, 0);
  return cut_shortest(corners, {cost, apex, n});
}

}  // namespace tensortopo
