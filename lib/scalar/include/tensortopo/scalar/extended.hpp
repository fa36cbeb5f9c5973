// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cfloat>

#if LDBL_MANT_DIG != 64 || defined(TENSORTOPO_SOFTWARE_EXTENDED)
#include "tensortopo/scalar/software_extended.hpp"
#endif

namespace tensortopo {

/// The binary format with 64 bits and exponents of 15 bits, rounded to nearest: the same numbers on
/// every machine. `long double` where that is this format (on AArch64 it is another one).
#if LDBL_MANT_DIG == 64 && !defined(TENSORTOPO_SOFTWARE_EXTENDED)
using Extended = long double;
#else
using Extended = SoftwareExtended;
#endif

/// A number of another library, to within a few roundings of the format; the same everywhere.
template <class Number>
Extended to_extended(const Number& x) {
  const double high = static_cast<double>(x);
  return Extended(high) + Extended(static_cast<double>(Number(x - Number(high))));
}

}  // namespace tensortopo
