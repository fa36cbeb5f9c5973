// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace tensortopo {

/// x 2^exponent, the bits of std::ldexp: where 2^exponent is a normal number, one multiplication.
inline double times_power(double x, int exponent) {
  constexpr int kBias = 1023;
  if (exponent <= -kBias || exponent > kBias) return std::ldexp(x, exponent);
  return x * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + kBias) << 52);
}

/// std::ilogb: of a normal number its exponent.
inline int floor_log2(double x) {
  constexpr int kBias = 1023, kLargest = 2047;
  const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & kLargest);
  return exponent == 0 || exponent == kLargest ? std::ilogb(x) : exponent - kBias;
}

/// A power of two that takes a number near to 1: into [1, 2) unless it is below 2^-1000, which goes
/// below 1, or at least 2^1001, which stays below 2^24.
/// @param x  finite
/// @return a normal number: products with it are exact where they do not underflow; 1 for x = 0
inline double inverse_power(double x) {
  return x == 0 ? 1 : std::ldexp(1.0, std::clamp(-std::ilogb(x), -1000, 1000));
}

}  // namespace tensortopo
