// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::theory {

/// Exact integer. Signs survive positive factors, so what is decided here needs no fractions.
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

}  // namespace tensortopo::theory
