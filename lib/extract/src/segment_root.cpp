// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/segment_root.hpp"

#include "extractor_scalars.hpp"

namespace tensortopo {

template <class Scalar>
Scalar segment_root(const Deviator<Scalar>& below, const Deviator<Scalar>& above,
                    const Level<Scalar>& level) {
  const Deviator<Scalar> step = above - below;
  const auto step3 = thrice(step);
  const Scalar f0 = level_function(below, level), f1 = level_function(above, level);
  if (!(f0 < Scalar(0))) return Scalar(0);
  if (!(f1 > Scalar(0))) return Scalar(1);
  const Scalar half = Scalar(1) / Scalar(2), tiny = unit_roundoff<Scalar>();
  Scalar lo(0), hi(1);
  Scalar t = -f0 / (f1 - f0);
  for (int iteration = 0; iteration < 400; ++iteration) {
    const auto at = level_slope(below + t * step, level);
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

#define TENSORTOPO_INSTANTIATE(Scalar)                                                 \
  template Scalar segment_root(const Deviator<Scalar>&, const Deviator<Scalar>&,       \
                               const Level<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
