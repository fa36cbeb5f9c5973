// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "extract/level/lanes/lanes.hpp"
#include "extract/level/level.hpp"
#include "extract/level/level_slope.hpp"
#include "extract/level/simd/four_lanes.hpp"

namespace tensortopo {

// Without linkage, see `Lanes`.
namespace {

using Mask = Lanes::Mask;

/// As far as the formulas look at it.
struct LaneLevel {
  Lanes mu, sqrt2;

  explicit LaneLevel(const LevelNumbers& level) : mu(level.mu), sqrt2(level.sqrt2) {}
};

/// A lane of each simplex.
template <std::size_t Vertices>
std::array<Deviator<Lanes>, Vertices> in_lanes(
    const std::array<const std::array<Deviator<double>, Vertices>*, Lanes::count>& of) {
  std::array<Deviator<Lanes>, Vertices> result;
  for (std::size_t i = 0; i < Vertices; ++i) {
    const auto gather = [&](double Deviator<double>::*part) {
      return Lanes(Lanes::Vector{(*of[0])[i].*part, (*of[1])[i].*part, (*of[2])[i].*part,
                                 (*of[3])[i].*part});
    };
    using Tensor = Deviator<double>;
    result[i] = {gather(&Tensor::a), gather(&Tensor::b), gather(&Tensor::xy), gather(&Tensor::yz),
                 gather(&Tensor::xz)};
  }
  return result;
}

/// The same; the last one in the lanes to spare.
template <std::size_t Vertices>
std::array<Deviator<Lanes>, Vertices> in_lanes(
    std::span<const std::array<Deviator<double>, Vertices>> simplices) {
  std::array<const std::array<Deviator<double>, Vertices>*, Lanes::count> of;
  for (std::size_t lane = 0; lane < Lanes::count; ++lane)
    of[lane] = &simplices[lane < simplices.size() ? lane : simplices.size() - 1];
  return in_lanes<Vertices>(of);
}

struct LaneSlope {
  Lanes value{};
  SymmetricTensor<Lanes> slope{};
};

/// As `segment_root`, between ends that are surely on their sides: the lanes in which they are not
/// are taken out of `lanes`.
inline Lanes roots_between(const Deviator<Lanes>& below, const Deviator<Lanes>& above,
                           const LaneLevel& level, Mask& lanes) {
  const Deviator<Lanes> step = above - below;
  const auto step3 = thrice(step);
  const auto value_at = [&](const Deviator<Lanes>& t) {  // as `level_function`
    const Lanes p = norm_form(t);
    return level.sqrt2 * determinant_form(t) - level.mu * p * sqrt(p);
  };
  const Lanes f0 = value_at(below), f1 = value_at(above);
  const Lanes half(0.5), tiny(unit_roundoff<double>());
  const Lanes unsure = Lanes(65536) * tiny * (abs(f0) + abs(f1));
  lanes &= (f0 < -unsure) & (f1 > unsure);
  Lanes lo(0), hi(1), t = -f0 / (f1 - f0);
  t = select((t > lo) & (t < hi), t, half * (lo + hi));
  Mask active = lanes;
  for (int iteration = 0; iteration < 400 && bits(active) != 0; ++iteration) {
    const auto at = detail::slope_at<LaneSlope>(below + t * step, level);
    const Mask less = at.value<Lanes(0), more = at.value> Lanes(0);
    lo = select(active & less, t, lo);
    hi = select(active & more, t, hi);
    active &= (less | more) & ~(hi - lo <= Lanes(2) * tiny);
    const Lanes derivative = inner(at.slope, step3);
    Lanes next = t - at.value / derivative;
    const Mask keep = iteration % 12 == 11 ? Mask{} : (next > lo) & (next < hi);
    next = select(keep, next, half * (lo + hi));
    const Lanes way = select(next > t, next - t, t - next);
    t = select(active, next, t);
    active &= ~(way <= tiny * select(t < half, Lanes(1), t));
  }
  return t;
}

}  // namespace
}  // namespace tensortopo
