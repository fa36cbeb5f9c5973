// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/multiprecision/gmp.hpp>

#include "tensortopo/scalar/scalar_traits.hpp"

namespace tensortopo {

/// Exact rational number (GMP). Every finite double converts to it without loss.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

/// Fractions of integers: see `ScalarTraits`.
template <>
struct ScalarTraits<Rational> {
  /// Arithmetic never rounds.
  static constexpr bool is_exact = true;
  /// Square roots and elementary functions exist.
  static constexpr bool has_roots = false;
  /// A value stands for a set that contains the true number.
  static constexpr bool is_enclosure = false;
};

}  // namespace tensortopo
