// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ball.hpp"
#include "polynomial.hpp"

namespace certificate {

/// Have all coefficients this sign, and so all values?
template <class N, std::size_t V, std::size_t D>
Answer have_sign(const Polynomial<N, V, D>& p, int sign, Zero zero) {
  Answer result = Answer::yes;
  for (const N& x : p.coefficients) {
    const Answer one = has_sign(x, sign, zero);
    if (one == Answer::no) return one;
    if (one == Answer::unsure) result = one;
  }
  return result;
}

template <class N, std::size_t V, std::size_t D>
Answer is_zero(const Polynomial<N, V, D>& p) {
  return both(have_sign(p, 1, Zero::will_do), [&] { return have_sign(p, -1, Zero::will_do); });
}

/// x / y to about the size of y, enclosed: x / 2^(bits of y).
inline Ball scaled(const mpz_class& x, const mpz_class& y) {
  return ball_of(x, static_cast<long>(mpz_sizeinbase(y.get_mpz_t(), 2)));
}

}  // namespace certificate
