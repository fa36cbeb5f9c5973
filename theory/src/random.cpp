// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/theory/random.hpp"

namespace tensortopo::theory {

std::uint64_t Random::next() {
  state_ += 0x9e3779b97f4a7c15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

int Random::integer(int low, int high) {
  const auto count = static_cast<std::uint64_t>(high - low) + 1;
  return low + static_cast<int>(next() % count);
}

int Random::nonzero(int bound) {
  const int size = integer(1, bound);
  return integer(0, 1) == 0 ? size : -size;
}

Rational Random::fraction() {
  const int numerator = integer(-9, 9);
  return Rational(numerator) / Rational(integer(1, 5));
}

Rational Random::part() {
  const int denominator = integer(1, 24);
  return Rational(integer(0, denominator)) / Rational(denominator);
}

}  // namespace tensortopo::theory
