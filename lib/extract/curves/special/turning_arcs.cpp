// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/special/turning_arcs.hpp"

#include <array>
#include <cmath>

#include "extract/curves/points/certified_zero.hpp"
#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

namespace {

ExactDirection exact(const std::array<int, 3>& v) {
  return {MultiprecisionInterval(double(v[0])), MultiprecisionInterval(double(v[1])),
          MultiprecisionInterval(double(v[2]))};
}

constexpr std::array<std::array<int, 3>, 12> kDirections{{{1, 2, 3},
                                                          {3, -1, 2},
                                                          {-2, 3, 1},
                                                          {5, 7, -11},
                                                          {13, -4, 5},
                                                          {-6, 17, 8},
                                                          {19, 23, 29},
                                                          {1, 0, 0},
                                                          {0, 1, 0},
                                                          {0, 0, 1},
                                                          {-31, 37, 12},
                                                          {41, 9, -43}}};

constexpr std::array<std::array<double, 2>, 6> kBetween{
    {{1, 1}, {1, 2}, {2, 1}, {1, 5}, {5, 1}, {3, 7}}};

/// What is certain about some place of the arc.
Verdict inside_of(const ExactDirection& first, const ExactDirection& second,
                  const InsideTest& inside) {
  for (const auto& [x, y] : kBetween) {
    const Verdict verdict =
        inside(normalized(MultiprecisionInterval(x) * first + MultiprecisionInterval(y) * second));
    if (is_strict(verdict)) return verdict;
  }
  return Verdict::unknown;
}

}  // namespace

std::optional<TurnOrder> order_in_plane(const ExactDirection& normal,
                                        std::span<const ExactDirection> directions) {
  for (const auto& candidate : kDirections) {
    // The angle is counted from the trace of a plane that holds none of the directions.
    const auto x = cross(normal, exact(candidate)), y = cross(normal, x);
    TurnOrder result;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Verdict side = sign_in(dot(y, directions[i]));
      if (!is_strict(side)) break;
      result.order.push_back(i);
      result.turned.push_back(side == Verdict::positive ? directions[i] : -directions[i]);
    }
    if (result.order.size() != directions.size()) continue;
    for (std::size_t i = 1; i < directions.size(); ++i)
      for (std::size_t k = i; k > 0; --k) {
        const Verdict turn = sign_in(dot(normal, cross(result.turned[k - 1], result.turned[k])));
        if (!is_strict(turn)) return std::nullopt;
        if (turn == Verdict::positive) break;
        std::swap(result.turned[k - 1], result.turned[k]);
        std::swap(result.order[k - 1], result.order[k]);
      }
    return result;
  }
  return std::nullopt;
}

std::optional<std::vector<TurningArc>> arcs_inside(const ExactDirection& normal,
                                                   std::span<const ExactDirection> directions,
                                                   const InsideTest& inside) {
  const auto order = order_in_plane(normal, directions);
  if (!order) return std::nullopt;
  std::vector<TurningArc> result;
  const std::size_t count = directions.size();
  const auto n = rounded_direction(normal);
  for (std::size_t i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    const ExactDirection& first = order->turned[i];
    const ExactDirection second = last ? -order->turned[0] : order->turned[i + 1];
    // Half a turn for one direction alone: a quarter of a turn on is between.
    const ExactDirection next = count == 1 ? normalized(cross(normal, first)) : second;
    const Verdict verdict = inside_of(first, next, inside);
    if (!is_strict(verdict)) return std::nullopt;
    if (verdict == Verdict::negative) continue;
    TurningArc arc;
    arc.begin = order->order[i];
    arc.end = order->order[last ? 0 : i + 1];
    arc.first = rounded_direction(first);
    const auto to = rounded_direction(second);
    arc.turn = count == 1
                   ? pi<double>()
                   : std::abs(elementary::atan2(static_cast<double>(dot(cross(n, arc.first), to)),
                                                static_cast<double>(dot(arc.first, to))));
    result.push_back(arc);
  }
  return result;
}

std::vector<Vector3<Extended>> directions_along(const ExactDirection& normal, const TurningArc& arc,
                                                double largest_turn) {
  std::vector<Vector3<Extended>> result;
  const auto side = cross(rounded_direction(normal), arc.first);
  const int parts = static_cast<int>(std::ceil(arc.turn / std::min(largest_turn, 0.5)));
  for (int k = 1; k < parts; ++k) {
    const double angle = arc.turn * k / parts;
    result.push_back(Extended(elementary::cos(angle)) * arc.first +
                     Extended(elementary::sin(angle)) * side);
  }
  return result;
}

}  // namespace tensortopo
