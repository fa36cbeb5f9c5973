// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A level is what a person wrote, as an exact fraction: 0.9 is not the double next to it.
// Expect: cannot convert|no viable conversion|could not convert|no matching function
#include "tensortopo/tensor/mode_parameter.hpp"

tensortopo::ModeValue level() {
#ifdef MUST_NOT_COMPILE
  return tensortopo::ModeValue::parse(0.9);
#else
  return tensortopo::ModeValue::parse("0.9");
#endif
}
