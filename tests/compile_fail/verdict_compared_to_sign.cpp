// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Expect: no match for|invalid operands
#include "tensortopo/scalar/sign.hpp"

bool agree(tensortopo::Verdict verdict) {
#ifdef MUST_NOT_COMPILE
  return verdict == tensortopo::Sign::zero;
#else
  return verdict == tensortopo::Verdict::zero;
#endif
}
