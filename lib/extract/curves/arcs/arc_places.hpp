// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "extract/curves/arcs/conic_arc.hpp"
#include "tensortopo/extract/curve_arcs.hpp"
#include "tensortopo/scalar/interval.hpp"

namespace tensortopo {

/// What powers of two the weights of doubles may differ by.
inline constexpr int kLargestRatio = 200;

inline FastInterval times_power(const FastInterval& x, int exponent) {
  return x * FastInterval(std::ldexp(1.0, exponent));
}
inline MultiprecisionInterval times_power(const MultiprecisionInterval& x, int exponent) {
  using End = MultiprecisionInterval::End;
  return {End(ldexp(x.low, exponent)), End(ldexp(x.high, exponent))};
}

inline Interval in_doubles(const FastInterval& x) { return {x.inf(), x.sup()}; }
inline Interval in_doubles(const MultiprecisionInterval& x) {
  // The conversion is rounded however: by less than this.
  const auto margin = [](double end) { return std::abs(end) * 0x1p-50 + 0x1p-1000; };
  const auto low = static_cast<double>(x.low), high = static_cast<double>(x.high);
  return {low - margin(low), high + margin(high)};
}

/// The barycentric weights along an arc, all times one polynomial that is positive on the arc.
template <class E>
using ArcWeights = std::array<std::array<E, 5>, 4>;

/// Where a point with these weights is; nothing if their sum is not certain to be positive, or the
/// box is not finite.
template <class E>
std::optional<PlaceBox> place_of(std::array<E, 4> weights,
                                 const std::array<Vector3<double>, 4>& points) {
  E sum = (weights[0] + weights[1]) + (weights[2] + weights[3]);
  if (sign_in(sum) != Verdict::positive) return std::nullopt;
  using std::frexp;
  int exponent = 0;
  typename EnclosureOf<E>::Bound high = EnclosureOf<E>::high(sum);
  frexp(high, &exponent);
  // Products of numbers of order one: what is far from it is left to other enclosures.
  if (std::is_same_v<E, FastInterval> && std::abs(exponent) > 900) return std::nullopt;
  const Interval total = in_doubles(times_power(sum, -exponent));
  if (!(total.inf() > 0)) return std::nullopt;
  std::array<Interval, 3> place{points[0].x, points[0].y, points[0].z};
  for (std::size_t i = 1; i < 4; ++i) {
    const Interval share = in_doubles(times_power(weights[i], -exponent)) / total;
    place[0] += share * (Interval(points[i].x) - Interval(points[0].x));
    place[1] += share * (Interval(points[i].y) - Interval(points[0].y));
    place[2] += share * (Interval(points[i].z) - Interval(points[0].z));
  }
  for (const Interval& x : place)
    if (!std::isfinite(x.inf()) || !std::isfinite(x.sup())) return std::nullopt;
  return PlaceBox{{place[0].inf(), place[1].inf(), place[2].inf()},
                  {place[0].sup(), place[1].sup(), place[2].sup()}};
}

/// Points of whose convex hull a part of the arc is one, enclosed; nothing if a sign is not
/// certain.
template <class E>
std::optional<std::array<PlaceBox, 5>> hull_of(const ArcWeights<E>& weights,
                                               const DyadicInterval& part,
                                               const std::array<Vector3<double>, 4>& points) {
  ArcWeights<E> own;
  for (std::size_t i = 0; i < 4; ++i) own[i] = restricted(weights[i], part);
  std::array<PlaceBox, 5> hull;
  for (std::size_t k = 0; k < 5; ++k) {
    const auto place = place_of<E>({own[0][k], own[1][k], own[2][k], own[3][k]}, points);
    if (!place) return std::nullopt;
    hull[k] = *place;
  }
  return hull;
}

/// The smallest box around boxes.
template <std::size_t Count>
PlaceBox box_around(const std::array<PlaceBox, Count>& boxes) {
  PlaceBox all = boxes[0];
  for (const PlaceBox& box : boxes) {
    all.low = {std::min(all.low.x, box.low.x), std::min(all.low.y, box.low.y),
               std::min(all.low.z, box.low.z)};
    all.high = {std::max(all.high.x, box.high.x), std::max(all.high.y, box.high.y),
                std::max(all.high.z, box.high.z)};
  }
  return all;
}

}  // namespace tensortopo
