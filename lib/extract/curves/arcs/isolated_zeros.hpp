// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "extract/curves/arcs/arc_polynomial.hpp"
#include "extract/curves/points/enclosures.hpp"

namespace tensortopo {

/// The zeros of a polynomial between 0 and 1.
struct IsolatedZeros {
  int begin = 0, end = 0;  ///< its signs at 0 and at 1; 0 if not certain
  std::vector<DyadicInterval>
      simple;                        ///< with exactly one zero inside each, a simple one; ascending
  std::vector<DyadicInterval> open;  ///< in which nothing is proved; elsewhere are no others
};

/// Halvings of [0, 1] in which zeros are told apart, and in which each is enclosed.
inline constexpr int kZeroDepth = 48;

inline int strict_sign(Verdict sign) {
  return sign == Verdict::positive ? 1 : sign == Verdict::negative ? -1 : 0;
}

/// By Descartes' rule for Bernstein's coefficients: no zeros between 0 and 1 if none of them
/// changes sign, exactly one, which is simple, if one does. The parts in which more do, or a sign
/// is not certain, are halved.
template <class E, std::size_t N>
class ZeroIsolation {
 public:
  explicit ZeroIsolation(const std::array<E, N>& polynomial, int depth = kZeroDepth)
      : depth_(depth) {
    zeros_.begin = strict_sign(sign_in(polynomial.front()));
    zeros_.end = strict_sign(sign_in(polynomial.back()));
    search(polynomial, {});
  }
  const IsolatedZeros& zeros() const { return zeros_; }

 private:
  /// More parts than any zeros leave: an unknown polynomial is given up early.
  static constexpr std::size_t kMostOpen = 64;

  void search(const std::array<E, N>& p, const DyadicInterval& part) {
    int changes = 0, last = 0;
    bool is_known = true;
    for (const E& c : p) {
      const int sign = strict_sign(sign_in(c));
      is_known = is_known && sign != 0;
      changes += last == -sign && sign != 0;
      last = sign;
    }
    if (is_known && changes == 0) return;
    if (is_known && changes == 1) {
      zeros_.simple.push_back(narrowed(p, part));
      return;
    }
    if (part.depth >= depth_ || zeros_.open.size() >= kMostOpen || all_unknown(p)) {
      zeros_.open.push_back(part);
      return;
    }
    search(left_half(p), part.left());
    search(right_half(p), part.right());
  }

  static bool all_unknown(const std::array<E, N>& p) {
    for (const E& c : p)
      if (sign_in(c) != Verdict::unknown && sign_in(c) != Verdict::zero) return false;
    return true;
  }

  DyadicInterval narrowed(std::array<E, N> p, DyadicInterval part) const {
    const int begin = strict_sign(sign_in(p.front()));
    while (part.depth < kZeroDepth) {
      const auto left = left_half(p);
      const int middle = strict_sign(sign_in(left.back()));
      if (middle == 0) break;
      const bool is_left = middle != begin;
      p = is_left ? left : right_half(p);
      part = is_left ? part.left() : part.right();
    }
    return part;
  }

  int depth_;
  IsolatedZeros zeros_;
};

}  // namespace tensortopo
