// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/real_zeros.hpp"

#include <algorithm>
#include <array>

namespace tensortopo::theory {
namespace {

// Of a polynomial: the remainders of Euclid's algorithm with its derivative, each negated.
std::vector<Polynomial> sturm_sequence(const Polynomial& p) {
  std::vector<Polynomial> sequence{p};
  for (Polynomial next = derivative(p); !next.is_zero();) {
    sequence.push_back(next);
    next = -remainder(sequence[sequence.size() - 2], sequence.back());
  }
  return sequence;
}

// Changes of sign along the sequence; zeros are skipped.
template <class SignOf>
int sign_changes(const std::vector<Polynomial>& sequence, const SignOf& sign_of_member) {
  int changes = 0;
  Sign last = Sign::zero;
  for (const Polynomial& p : sequence) {
    const Sign sign = sign_of_member(p);
    if (sign == Sign::zero) continue;
    if (last != Sign::zero && sign != last) ++changes;
    last = sign;
  }
  return changes;
}

int changes_at(const std::vector<Polynomial>& sequence, const Rational& x) {
  return sign_changes(sequence, [&](const Polynomial& p) { return p.sign_at(x); });
}

// A point inside at which p is not zero: the middle, or one closer and closer to the lower end.
Rational cut(const Polynomial& p, const Rational& low, const Rational& high) {
  Rational x = (low + high) / Rational(2);
  while (p.sign_at(x) == Sign::zero) x = (low + x) / Rational(2);
  return x;
}

// Bits by which the intervals are narrowed beforehand: with these most signs are certain at once.
constexpr int kBits = 48;

}  // namespace

RealZeros::RealZeros(const Polynomial& squarefree) : polynomial_(squarefree) {
  const auto sequence = sturm_sequence(squarefree);
  const int at_plus =
      sign_changes(sequence, [](const Polynomial& p) { return p.sign_at_infinity(); });
  const int at_minus = sign_changes(sequence, [](const Polynomial& p) {
    return p.degree() % 2 == 0 ? p.sign_at_infinity() : -p.sign_at_infinity();
  });
  Rational bound(1);
  const auto beyond = [&](const Rational& x, int changes) {
    return squarefree.sign_at(x) != Sign::zero && changes_at(sequence, x) == changes;
  };
  while (!beyond(-bound, at_minus) || !beyond(bound, at_plus)) bound = bound * Rational(4);
  struct Piece {
    Interval interval;
    int at_low, at_high;
  };
  std::vector<Piece> pieces{{{-bound, bound}, at_minus, at_plus}};
  while (!pieces.empty()) {
    const Piece piece = pieces.back();
    pieces.pop_back();
    const auto& [low, high] = piece.interval;
    if (piece.at_low - piece.at_high == 1) zeros_.push_back(piece.interval);
    if (piece.at_low - piece.at_high <= 1) continue;
    const Rational middle = cut(squarefree, low, high);
    const int at_middle = changes_at(sequence, middle);
    pieces.push_back({{middle, high}, at_middle, piece.at_high});
    pieces.push_back({{low, middle}, piece.at_low, at_middle});
  }
  for (Interval& zero : zeros_) {
    for (int bit = 0; bit < kBits; ++bit) halve(zero);
  }
}

void RealZeros::halve(Interval& interval) const {
  const Rational middle = cut(polynomial_, interval.low, interval.high);
  const bool below = polynomial_.sign_at(interval.low) != polynomial_.sign_at(middle);
  (below ? interval.high : interval.low) = middle;
}

// `common` is the greatest common divisor with q; it changes sign at each of its zeros.
Sign RealZeros::sign(const Polynomial& q, const Polynomial& common, Interval interval) const {
  if (common.sign_at(interval.low) != common.sign_at(interval.high)) return Sign::zero;
  while (true) {
    const Rational value = q.value_at(interval.low);
    const Rational size = std::max(Rational(abs(interval.low)), Rational(abs(interval.high)));
    if (abs(value) > (interval.high - interval.low) * q.steepest_within(size)) {
      return sign_of(value);
    }
    for (int bit = 0; bit < kBits; ++bit) halve(interval);
  }
}

Sign RealZeros::sign(const Polynomial& q, std::size_t zero) const {
  return sign(q, greatest_common_divisor(polynomial_, q), zeros_[zero]);
}

std::vector<Sign> RealZeros::signs(const Polynomial& q) const {
  const Polynomial common = greatest_common_divisor(polynomial_, q);
  std::vector<Sign> result;
  for (const Interval& zero : zeros_) result.push_back(sign(q, common, zero));
  return result;
}

}  // namespace tensortopo::theory
