// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Parts of simplices, by bisection.
#pragma once

#include <vector>

#include "widened.hpp"

namespace certificate {

/// A point of a simplex by weights that are exact doubles, with what members have there.
template <std::size_t V>
struct Point {
  std::array<double, V> weights{};
  Matrix matrix;
  double radius = 0, norm = 0;  ///< rounded up
};

template <std::size_t V>
Point<V> point_at(const std::array<Widened, V>& corners, const std::array<double, V>& weights) {
  Point<V> point;
  point.weights = weights;
  for (std::size_t i = 0; i < V; ++i) {
    point.matrix = point.matrix + Ball(weights[i], 0) * corners[i].centre;
    point.radius = (point.radius + weights[i] * corners[i].radius) * Ball::kSlack;
  }
  point.norm = largest_norm(point.matrix);
  return point;
}

template <std::size_t V, std::size_t C>
std::array<std::array<double, V>, C> weights_of(const std::array<Point<V>, C>& part) {
  std::array<std::array<double, V>, C> weights;
  for (std::size_t a = 0; a < C; ++a) weights[a] = part[a].weights;
  return weights;
}

/// Most parts of a simplex of V vertices.
template <std::size_t V>
constexpr int kParts = V == 2 ? 96 : V == 3 ? 768 : 6144;
/// Weights of parts are multiples of 2 to the minus so many, which doubles hold.
constexpr int kMostBits = 50;

/// Does a simplex consist of parts in each of which something is shown? Yes or unsure.
/// @param holds     is it shown in a part?
/// @param may_hold  of a part's centre: could it be shown in a small part around?
template <std::size_t V, class Holds, class MayHold>
Answer holds_in_parts(const std::array<Widened, V>& corners, const Holds& holds,
                      const MayHold& may_hold) {
  std::array<std::array<double, V>, V> whole{};
  for (std::size_t i = 0; i < V; ++i) whole[i][i] = 1;
  struct Open {
    std::array<std::array<double, V>, V> places;
    int halvings = 0;  ///< that it came of: weights have no more bits
  };
  std::vector<Open> open{{whole}};
  for (int count = 0; !open.empty(); ++count) {
    const auto [places, halvings] = open.back();
    if (count == kParts<V> || halvings == kMostBits) return Answer::unsure;
    open.pop_back();
    std::array<Point<V>, V> part;
    for (std::size_t a = 0; a < V; ++a) part[a] = point_at(corners, places[a]);
    if (holds(part)) continue;
    std::array<double, V> centre{};
    for (const auto& place : places)
      for (std::size_t i = 0; i < V; ++i) centre[i] += place[i] / static_cast<double>(V);
    if (!may_hold(std::array<Point<V>, 1>{point_at(corners, centre)}))
      return Answer::unsure;  // however small a part is
    std::size_t from = 0, to = 1;
    double least = 2;
    for (std::size_t a = 0; a < V; ++a)
      for (std::size_t b = a + 1; b < V; ++b) {
        const double cosine =
            inner(part[a].matrix, part[b].matrix).value / (part[a].norm * part[b].norm);
        if (cosine < least) least = cosine, from = a, to = b;
      }
    std::array<double, V> half{};
    for (std::size_t i = 0; i < V; ++i) half[i] = (places[from][i] + places[to][i]) / 2;
    for (const std::size_t corner : {from, to}) {
      open.push_back({places, halvings + 1});
      open.back().places[corner] = half;
    }
  }
  return Answer::yes;
}

}  // namespace certificate
