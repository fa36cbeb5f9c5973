// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/proofs/likely_direction.hpp"

#include <algorithm>
#include <cmath>

#include "extract/level/lanes/has_lanes.hpp"
#include "extract/level/proofs/direction_in_lanes.hpp"
#include "extract/level/proofs/direction_search.hpp"

namespace tensortopo {

namespace {

/// The place of the least number, the first of several; 0 if there is none. Lanes side by side,
/// which a compiler keeps in registers.
template <std::size_t Count>
std::size_t least_of(const std::array<double, Count>& x) {
  constexpr std::size_t lanes = 4;
  std::array<double, lanes> low;
  for (std::size_t j = 0; j < lanes; ++j) low[j] = x[j];
  std::size_t k = lanes;
  for (; k + lanes <= Count; k += lanes)
    for (std::size_t j = 0; j < lanes; ++j) low[j] = x[k + j] < low[j] ? x[k + j] : low[j];
  double least = low[0];
  for (std::size_t j = 1; j < lanes; ++j) least = low[j] < least ? low[j] : least;
  for (; k < Count; ++k) least = x[k] < least ? x[k] : least;
  for (std::size_t i = 0; i < Count; ++i)
    if (x[i] == least) return i;
  return 0;
}

}  // namespace

template <std::size_t Vertices>
std::array<double, Vertices> DirectionSearch<Vertices>::run(int step, int steps) {
#ifdef TENSORTOPO_FOUR_LANES
  if (has_lanes()) return direction_in_lanes(*this, step, steps);
#endif
  // Tensors of a size that overflows have no directions.
  for (const double x : d)
    if (!(x - x == 0)) return {};
  for (;; ++step) {
    std::array<double, count> growth;
    for (std::size_t k = 0; k < count; ++k) growth[k] = d[0] * unit[0][k];
    for (std::size_t i = 1; i < Vertices; ++i)
      for (std::size_t k = 0; k < count; ++k) growth[k] += d[i] * unit[i][k];
    const std::size_t least = least_of(growth);
    double square = 0;
    for (const double x : d) square += x * x;
    if (growth[least] > enough) break;
    if (!(square > nothing * nothing) || step == steps) return {};
    std::size_t most = count;
    for (std::size_t k = 0; k < count; ++k)
      if (weight[k] > 0 && (most == count || growth[k] > growth[most])) most = k;
    double gap = 0;
    for (std::size_t i = 0; i < Vertices; ++i)
      gap += (unit[i][least] - unit[i][most]) * (unit[i][least] - unit[i][most]);
    if (!(gap > 0)) return {};
    const double shift = std::min(weight[most], (growth[most] - growth[least]) / gap);
    weight[least] += shift;
    weight[most] -= shift;
    for (std::size_t i = 0; i < Vertices; ++i) d[i] += shift * (unit[i][least] - unit[i][most]);
  }
  double largest = 0;
  for (const double x : d) largest = std::max(largest, std::abs(x));
  for (auto& x : d) x /= largest;
  return d;
}

template <std::size_t Vertices>
std::array<double, Vertices> likely_direction(const LevelIncrease<double, Vertices>& increase,
                                              int steps, bool of_sum_zero) {
#ifdef TENSORTOPO_FOUR_LANES
  if (has_lanes()) return direction_in_lanes(increase, steps, of_sum_zero);
#endif
  // The two cubics of each kind differ little: between them. Unit directions, by coordinate.
  DirectionSearch<Vertices> search;
  constexpr std::size_t count = search.count;
  auto& unit = search.unit;
  for (std::size_t i = 0; i < Vertices; ++i)
    for (std::size_t k = 0; k < count; ++k)
      unit[i][k] = increase.along[i][k] + increase.along[i][count + k];
  std::array<double, count> factor{};
  if (of_sum_zero) {
    for (std::size_t i = 0; i < Vertices; ++i)
      for (std::size_t k = 0; k < count; ++k) factor[k] += unit[i][k] / Vertices;
    for (std::size_t i = 0; i < Vertices; ++i)
      for (std::size_t k = 0; k < count; ++k) unit[i][k] -= factor[k];
    factor.fill(0);
  }
  for (std::size_t i = 0; i < Vertices; ++i)
    for (std::size_t k = 0; k < count; ++k) factor[k] += unit[i][k] * unit[i][k];
  for (auto& f : factor) f = 1 / std::sqrt(f);
  for (std::size_t i = 0; i < Vertices; ++i) {
    auto& d = search.d[i];
    for (std::size_t k = 0; k < count; ++k) unit[i][k] *= factor[k];
    for (std::size_t k = 0; k < count; ++k) d += unit[i][k];
    d /= count;
  }
  search.weight.fill(1.0 / count);
  return search.run(0, steps);
}

template struct DirectionSearch<3>;
template struct DirectionSearch<4>;
template std::array<double, 3> likely_direction(const LevelIncrease<double, 3>&, int, bool);
template std::array<double, 4> likely_direction(const LevelIncrease<double, 4>&, int, bool);

}  // namespace tensortopo
