// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The parameter s of a mode is a root: rationals do not hold it.
// Expect: RealScalar|constraints not satisfied
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

#ifdef MUST_NOT_COMPILE
using Scalar = tensortopo::Rational;
#else
using Scalar = double;
#endif

Scalar s_of(const tensortopo::ModeValue& mode) {
  return tensortopo::mode_parameter<Scalar>(mode).s;
}
