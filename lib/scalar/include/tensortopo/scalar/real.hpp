// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/multiprecision/mpfr.hpp>

#include "tensortopo/scalar/scalar_traits.hpp"

namespace tensortopo {

/// MPFR number of a fixed count of decimal digits, rounded to nearest.
///
/// The digits are part of the type: the thread-default precision of variable-precision MPFR
/// numbers must never decide what a template computes. Storage is on the stack, so that a
/// computation allocates nothing.
template <unsigned Digits>
using Real = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

using Real50 = Real<50>;
using Real100 = Real<100>;

/// Floating point numbers of MPFR: see `ScalarTraits`.
template <unsigned Digits>
struct ScalarTraits<Real<Digits>> {
  /// Arithmetic never rounds.
  static constexpr bool is_exact = false;
  /// Square roots and elementary functions exist.
  static constexpr bool has_roots = true;
  /// A value stands for a set that contains the true number.
  static constexpr bool is_enclosure = false;
};

}  // namespace tensortopo
