// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/segment_root.hpp"

#include <type_traits>

#include "extract/level/level_slope.hpp"
#include "extract/level/multiprecision_level.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// As `segment_root`, to within `tiny`.
template <class Scalar>
Scalar root_between(const Deviator<Scalar>& below, const Deviator<Scalar>& above,
                    const Level<Scalar>& level, const Scalar& tiny) {
  const Deviator<Scalar> step = above - below;
  const auto step3 = thrice(step);
  const Scalar f0 = level_function(below, level), f1 = level_function(above, level);
  const Scalar half = Scalar(1) / Scalar(2);
  Scalar lo(0), hi(1);
  // Values below this may be rounding. A guide to where to look, not a bound: it places a sample,
  // and decides no topology.
  const Scalar unsure =
      Scalar(65536) * tiny * ((f0 < Scalar(0) ? -f0 : f0) + (f1 < Scalar(0) ? -f1 : f1));
  // An end on the level, to rounding, need not be the crossing: the mode may leave it for the side
  // that it counts to, even with derivative zero, and cross the level further on. As there is one
  // crossing, any point inside on the end's own side has it beyond.
  const auto inward = [&](bool at_below) {
    for (Scalar k = half; k > tiny; k = half * k) {
      const Scalar place = at_below ? k : Scalar(1) - k;
      const Scalar f = level_function(below + place * step, level);
      if (at_below ? !(f < -unsure) : !(f > unsure)) continue;
      (at_below ? lo : hi) = place;
      return true;
    }
    return false;
  };
  if (!(f0 < -unsure) && !inward(true) && !(f0 < Scalar(0))) return Scalar(0);
  if (!(f1 > unsure) && !inward(false) && !(f1 > Scalar(0))) return Scalar(1);
  Scalar t = -f0 / (f1 - f0);
  if (!(t > lo && t < hi)) t = half * (lo + hi);
  for (int iteration = 0; iteration < 400; ++iteration) {
    const auto at = detail::slope_at<LevelSlope<Scalar>>(below + t * step, level);
    if (at.value < Scalar(0))
      lo = t;
    else if (at.value > Scalar(0))
      hi = t;
    else
      return t;
    if (hi - lo <= Scalar(2) * tiny) break;
    const Scalar derivative = inner(at.slope, step3);
    Scalar next = t - at.value / derivative;
    // Bisect when Newton leaves the bracket, does not exist, or has had its turns.
    if (!(next > lo && next < hi) || iteration % 12 == 11) next = half * (lo + hi);
    const Scalar move = next > t ? next - t : t - next;
    t = next;
    if (move <= tiny * (t < half ? Scalar(1) : t)) break;
  }
  return t;
}

}  // namespace

template <class Scalar>
Scalar segment_root(const Deviator<Scalar>& below, const Deviator<Scalar>& above,
                    const Level<Scalar>& level) {
  if constexpr (std::is_same_v<Scalar, double>)
    if (is_inconclusive_in_double(level)) {
      using Wide = Multiprecision<double>::type;
      return static_cast<double>(
          root_between<Wide>(tensor_cast<Wide>(below), tensor_cast<Wide>(above),
                             level_in<Wide>(level.value), Wide(unit_roundoff<double>())));
    }
  return root_between<Scalar>(below, above, level, unit_roundoff<Scalar>());
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                           \
  template Scalar segment_root(const Deviator<Scalar>&, const Deviator<Scalar>&, \
                               const Level<Scalar>&);
TENSORTOPO_FOR_EACH_PRECISION(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
