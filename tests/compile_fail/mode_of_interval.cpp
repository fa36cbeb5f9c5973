// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Enclosures have no order, so an algorithm that compares values does not take them.
// Expect: RealScalar|constraints not satisfied
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/tensor/mode.hpp"

#ifdef MUST_NOT_COMPILE
using Scalar = tensortopo::Interval;
#else
using Scalar = double;
#endif

Scalar mode_of(const tensortopo::Deviator<Scalar>& deviator) { return tensortopo::mode(deviator); }
