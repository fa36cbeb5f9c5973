// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/level/level.hpp"
#include "extract/level/mode_forms.hpp"

namespace tensortopo::detail {

/// `level_slope` over any scalar with a root; `Slope` is like `LevelSlope`, of `level` only mu and
/// the root of 2 are wanted.
template <class Slope, class Scalar, class AnyLevel>
Slope slope_at(const Deviator<Scalar>& t, const AnyLevel& level) {
  using std::sqrt;
  const auto m = thrice(t);  // Q = det m, P = |m|^2 / 3
  const Scalar p = norm_form(t);
  const Scalar root = sqrt(p);
  const auto adjugate = polar_adjugate(m, m);  // twice the adjugate
  Slope result;
  result.value = level.sqrt2 * (inner(adjugate, m) / Scalar(6)) - level.mu * p * root;
  // dQ = <adj m, dm>, dP = (2/3) <m, dm>, d P^(3/2) = (3/2) sqrt(P) dP.
  result.slope = (level.sqrt2 / Scalar(2)) * adjugate - (level.mu * root) * m;
  return result;
}

}  // namespace tensortopo::detail
