// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// "Unknown" is not a sign: who wants one has to deal with it.
// Expect: cannot convert|cannot initialize
#include "tensortopo/scalar/sign.hpp"

tensortopo::Sign sign(tensortopo::Verdict verdict) {
#ifdef MUST_NOT_COMPILE
  tensortopo::Sign result = verdict;
#else
  tensortopo::Sign result = verdict == tensortopo::Verdict::positive
                                ? tensortopo::Sign::positive
                                : tensortopo::Sign::negative;
#endif
  return result;
}
