// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {

/// The number of a format that is nearest to `value`, of two the even one: rounded once, where
/// GMP's own conversion truncates. For double, `Real50` and `Real100`.
template <class Scalar>
Scalar nearest(const Rational& value);

/// The same number as a rational.
/// @pre x is finite
inline Rational exactly(double x) { return Rational(x); }
template <unsigned Digits>
Rational exactly(const Real<Digits>& x) {
  Rational result;
  mpfr_get_q(result.backend().data(), x.backend().data());
  return result;
}

}  // namespace tensortopo
