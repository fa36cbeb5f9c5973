// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A type without ScalarTraits is refused by name, not by the linker.
// Expect: RingScalar|constraints not satisfied
#include "tensortopo/tensor/mode.hpp"

#ifdef MUST_NOT_COMPILE
using Scalar = float;
#else
using Scalar = double;
#endif

Scalar form(const tensortopo::Deviator<Scalar>& deviator) {
  return tensortopo::discriminant_form(deviator);
}
