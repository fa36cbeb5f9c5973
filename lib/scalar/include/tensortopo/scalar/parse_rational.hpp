// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {

/// The number that a person wrote, exactly: "0.5", "-9/10", "1e-6", "143/343".
///
/// Accepts an optional sign followed by either a decimal number (digits on at least one side of
/// the point, optional exponent) or two natural numbers separated by '/'. Throws
/// std::invalid_argument, whose text is the reason alone, for anything else, for a zero
/// denominator, for text longer than 300 characters, an exponent beyond 300 or a nonzero value
/// closer to zero than 1e-300.
Rational parse_rational(std::string_view text);

}  // namespace tensortopo
