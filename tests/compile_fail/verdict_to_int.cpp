// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Expect: cannot convert|cannot initialize
#include "tensortopo/scalar/sign.hpp"

int number(tensortopo::Verdict verdict) {
#ifdef MUST_NOT_COMPILE
  int result = verdict;
#else
  int result = static_cast<int>(verdict);
#endif
  return result;
}
