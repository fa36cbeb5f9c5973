// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>

namespace certificate {

/// The number that a text like "0x1.8p-3" is, exactly: digits in lower case, and at most one point
/// among them; without "p" its exponent is 0. Nothing if it is none, or its exponent is beyond
/// 10000.
std::optional<mpq_class> hexadecimal(const std::string& text);

}  // namespace certificate
