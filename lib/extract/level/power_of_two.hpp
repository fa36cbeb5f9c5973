// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

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

}  // namespace tensortopo
