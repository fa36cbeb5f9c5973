// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CGAL/Interval_nt.h>

#include "tensortopo/scalar/scalar_traits.hpp"
#include "tensortopo/scalar/sign.hpp"

namespace tensortopo {

/// Closed interval of doubles that contains the true value of every + - * / applied to it.
///
/// The protected flavour: each operation sets its own rounding direction, so that no client has to
/// remember a guard (the unprotected flavour without one returns sets that miss the true value).
/// Sources that compute with it are compiled with -frounding-math. Comparisons of overlapping
/// intervals have no answer: use `certified_sign`.
using Interval = CGAL::Interval_nt<true>;

/// Intervals of doubles: see `ScalarTraits`.
template <>
struct ScalarTraits<Interval> {
  /// Arithmetic never rounds.
  static constexpr bool is_exact = false;
  /// Square roots and elementary functions exist.
  static constexpr bool has_roots = false;
  /// A value stands for a set that contains the true number.
  static constexpr bool is_enclosure = true;
};

/// The sign shared by all numbers of an interval; unknown if they differ or an end is not a number.
/// The interval [0, 0] proves zero.
inline Verdict certified_sign(const Interval& value) {
  if (value.inf() > 0) return Verdict::positive;
  if (value.sup() < 0) return Verdict::negative;
  if (value.inf() == 0 && value.sup() == 0) return Verdict::zero;
  return Verdict::unknown;
}

}  // namespace tensortopo
