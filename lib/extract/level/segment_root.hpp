// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/level/level.hpp"

namespace tensortopo {

/// The point of the level on a segment of tensors that crosses it once.
///
/// @param below,above tensors at the ends; the mode at `below` is at most mu, at `above` larger.
/// @return the parameter in [0, 1], from `below` to `above`, to the precision of the scalar.
///
/// Newton's method kept inside a bracket. The crossing is known to exist; should rounding hide the
/// change of sign (an end within rounding of the level), that end is the answer, unless the mode
/// leaves it for the side that it counts to.
template <class Scalar>
Scalar segment_root(const Deviator<Scalar>& below, const Deviator<Scalar>& above,
                    const Level<Scalar>& level);

/// The same on a segment given the other way as well: the parameter from `from` to `to`, the mode
/// being larger at `to` if `rising`, else at `from`.
template <class Scalar>
Scalar segment_root(const Deviator<Scalar>& from, const Deviator<Scalar>& to, bool rising,
                    const Level<Scalar>& level) {
  return rising ? segment_root(from, to, level) : Scalar(1) - segment_root(to, from, level);
}

}  // namespace tensortopo
