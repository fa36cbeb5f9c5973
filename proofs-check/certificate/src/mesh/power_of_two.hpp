// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <cstdlib>

namespace certificate {

/// x times 2^exponent.
inline mpq_class times_power_of_two(const mpq_class& x, long exponent) {
  const auto by = static_cast<mp_bitcnt_t>(std::labs(exponent));
  return exponent < 0 ? mpq_class(x >> by) : mpq_class(x << by);
}

}  // namespace certificate
