// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/multiprecision/gmp.hpp>

#include "tensortopo/scalar/scalar_traits.hpp"

namespace tensortopo {

/// Exact rational number (GMP). Every finite double converts to it without loss.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

template <>
struct ScalarTraits<Rational> {
  static constexpr bool is_exact = true;
  static constexpr bool has_roots = false;
  static constexpr bool is_enclosure = false;
};

}  // namespace tensortopo
