// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Where the mode is greater than mu: signs of Q and of a form of degree six.
#pragma once

#include <cmath>

#include "forms.hpp"
#include "signs.hpp"

namespace certificate {

class ModeRule {
 public:
  /// @pre |numerator| < denominator
  ModeRule(const mpz_class& numerator, const mpz_class& denominator)
      : sign_(sgn(numerator)),
        exact_{54 * denominator * denominator, -numerator * numerator},
        balls_{scaled(exact_.q, exact_.q), scaled(exact_.p, exact_.q)},
        root_{scaled(denominator, denominator), scaled(-numerator, denominator)} {}

  template <class N, std::size_t V>
  Forms<N, V> forms(const std::array<const Tensor<N>*, V>& tensors) const {
    return Forms<N, V>(tensors);
  }
  /// Is all of the simplex on this side? Points of mode exactly mu are below.
  template <class N, std::size_t V>
  Answer lies(bool above, const Forms<N, V>& f) const;
  /// The same in other ways.
  template <std::size_t V>
  bool lies_by_norm(bool above, const std::array<const Tensor<Ball>*, V>& corners,
                    const Forms<Ball, V>& f) const;
  /// Is the mode exactly mu, there being one? Neither this sign of the form nor the other.
  template <class N>
  Answer is_on(const Forms<N, 1>& f) const {
    if (sign_ == 0) return is_zero(f.q);
    return both(have_sign(f.q, sign_, Zero::fails), [&] { return is_zero(degree_six(f)); });
  }
  /// Is there a mode everywhere?
  template <class N, std::size_t V>
  static Answer is_defined(const Forms<N, V>& f) {
    return have_sign(f.p, 1, Zero::fails);
  }

 private:
  /// F = q Q^2 + p P^3.
  template <class N>
  struct Factors {
    N q, p;
  };
  template <class N, std::size_t V>
  Polynomial<N, V, 6> degree_six(const Forms<N, V>& f) const {
    const auto form = [&](const auto& factors) {
      return combination(factors.q, f.q * f.q, factors.p, f.p * f.p * f.p);
    };
    if constexpr (std::is_same_v<N, Ball>) return form(balls_);
    else return form(exact_);
  }

  int sign_;  ///< of mu
  Factors<mpz_class> exact_;
  Factors<Ball> balls_;  ///< both divided by one positive number
  Factors<Ball> root_;  ///< of q Q + p P sqrt(P/54), of the sign of the mode less mu; divided alike
};

template <class N, std::size_t V>
Answer ModeRule::lies(bool above, const Forms<N, V>& f) const {
  const auto q_is = [&](int sign, Zero zero) { return have_sign(f.q, sign, zero); };
  const auto f_is = [&](int sign, Zero zero) {
    return [&f, this, sign, zero] { return have_sign(degree_six(f), sign, zero); };
  };
  if (sign_ == 0) return above ? q_is(1, Zero::fails) : q_is(-1, Zero::will_do);
  if (sign_ > 0)
    return above ? both(q_is(1, Zero::fails), f_is(1, Zero::fails))
                 : either(q_is(-1, Zero::will_do), f_is(-1, Zero::will_do));
  return above ? either(q_is(1, Zero::will_do), f_is(-1, Zero::fails))
               : both(q_is(-1, Zero::fails), f_is(1, Zero::will_do));
}

/// By a form that vanishes at mu only. (F does so at -mu as well, where the answer would need parts
/// as narrow as all between.) With a linear bound s of sqrt(P/54), from above by convexity or from
/// below by Cauchy's inequality.
template <std::size_t V>
bool ModeRule::lies_by_norm(bool above, const std::array<const Tensor<Ball>*, V>& corners,
                            const Forms<Ball, V>& f) const {
  if (sign_ == 0) return false;
  const int side = above ? 1 : -1;
  Polynomial<Ball, V, 1> s;
  if (side == sign_) {
    for (std::size_t i = 0; i < V; ++i) {
      const Ball square = trace(*corners[i], *corners[i]);
      const Ball root((1 + 0x1p-40) * std::sqrt(square.value / 54), 0);
      if (has_sign(Ball(54) * root * root - square, 1, Zero::fails) != Answer::yes) return false;
      s.coefficients[i] = root;
    }
  } else {
    // For all E with 54 tr(E^2) < 1: here about the mean of the corners.
    Tensor<Ball> e{};
    for (const Tensor<Ball>* corner : corners) {
      const double length = std::sqrt(trace(*corner, *corner).value);
      for (std::size_t k = 0; k < 6; ++k) e[k].value += (*corner)[k].value / length;
    }
    const double factor = (1 - 0x1p-40) / std::sqrt(54 * trace(e, e).value);
    for (Ball& x : e) x.value *= factor;
    if (has_sign(Ball(1) - Ball(54) * trace(e, e), 1, Zero::fails) != Answer::yes) return false;
    for (std::size_t i = 0; i < V; ++i) s.coefficients[i] = trace(*corners[i], e);
  }
  const auto form = combination(root_.q, f.q, root_.p, f.p * s);
  return have_sign(form, side, Zero::fails) == Answer::yes;
}

}  // namespace certificate
