// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A tier that cannot tell must not read as "not zero" or "zero".
// Expect: could not convert|no viable conversion|not contextually convertible|cannot convert
#include "tensortopo/scalar/sign.hpp"

bool known(tensortopo::Verdict verdict) {
#ifdef MUST_NOT_COMPILE
  if (verdict) return true;
#else
  if (verdict != tensortopo::Verdict::unknown) return true;
#endif
  return false;
}
