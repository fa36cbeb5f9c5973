// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>

namespace tensortopo {

/// Fractions up to this length are shown as they are.
constexpr std::size_t kLongestFraction = 20;

/// A mode, or an invariant's value, for a line that people read: the exact fraction, or where that
/// is long (1e-300 has a denominator of 301 digits) the shortest decimal of the nearest double.
/// Files and JSON have the fraction.
template <class Value>
std::string short_text(const Value& value) {
  std::string text(value.text());
  return text.size() <= kLongestFraction ? text : fmt::format("{}", value.approx());
}

}  // namespace tensortopo
