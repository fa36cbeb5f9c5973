// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/meshing_message.hpp"

#include <bit>

namespace tensortopo {

std::uint64_t digest_of(std::span<const double> numbers) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const double x : numbers) {
    // The finalizer of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
    hash = (hash ^ std::bit_cast<std::uint64_t>(x)) + 0x9e3779b97f4a7c15;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111eb;
    hash ^= hash >> 31;
  }
  return hash;
}

}  // namespace tensortopo
