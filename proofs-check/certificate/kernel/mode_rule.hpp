// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Where the mode is greater than mu: signs of Q and of a form of degree six.
#pragma once

#include <cmath>

#include "forms.hpp"

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
  /// The same by a form that vanishes at mu only. (F does so at -mu as well, where the answer would
  /// need parts as narrow as all between.)
  template <std::size_t V>
  bool lies_by_norm(bool above, const Forms<Ball, V>& f) const {
    if (sign_ == 0) return false;
    const auto s = root_bound(above == (sign_ > 0), f.p);
    return have_sign(combination(root_.q, f.q, root_.p, f.p * s), above ? 1 : -1, Zero::fails) ==
           Answer::yes;
  }
  /// Of a direction d: forms that are positive only if the mode increases along d wherever it is mu.
  /// They are the derivatives of `root_`'s form, q dQ + 3/2 p sqrt(P/54) dP, with a bound from below
  /// and one from above for the root, of which that is an affine function.
  template <std::size_t V>
  auto rise(const Forms<Ball, V>& f) const {
    return [&f, this, lower = root_bound(false, f.p),
            upper = root_bound(true, f.p)](const std::array<int, V>& d) {
      const auto dq = derivative(f.q, d);
      const auto dp = derivative(f.p, d);
      const Ball p = Ball(1.5, 0) * root_.p;
      return std::array{combination(root_.q, dq, p, lower * dp),
                        combination(root_.q, dq, p, upper * dp)};
    };
  }
  /// A number h with tr(M T) < h |T| for all T of mode mu, if it is found: of the size |M| cos x, where
  /// 3 x is the difference of the modes' arc cosines. See the README.
  double reach(const Forms<Ball, 1>& f) const {
    const Ball &p = f.p.coefficients[0], &q = f.q.coefficients[0], root(std::sqrt(54.0), 0x1p-48);
    const double norm = std::sqrt(p.value), mode = root.value * q.value / (norm * norm * norm);
    const double level = -root_.p.value / root_.q.value;
    const double angle = std::acos(std::clamp(mode, -1.0, 1.0)) - std::acos(level);
    const Ball h(norm * (std::cos(angle / 3) + 0x1p-30), 0);
    const Ball z = root_.q * (Ball(4) * h * h * h - Ball(3) * p * h) + root_.p * root * q;
    const Ball sines = (p * p * p - Ball(54) * q * q) * (root_.q * root_.q - root_.p * root_.p);
    for (const Ball& x : {z, z * z - sines, Ball(4) * h * h - p})
      if (has_sign(x, 1, Zero::fails) != Answer::yes) return HUGE_VAL;
    return h.value;
  }
  double tube() const { return 1 + 54 * balls_.p.value / balls_.q.value; }
  /// Is the mode exactly mu, there being one? Neither this sign of the form nor the other.
  template <class N>
  Answer is_on(const Forms<N, 1>& f) const {
    if (sign_ == 0) return is_zero(f.q);
    return both(have_sign(f.q, sign_, Zero::fails), [&] { return is_zero(degree_six(f)); });
  }
  /// Is there a mode everywhere?
  template <class N, std::size_t V>
  static Answer is_defined(const Forms<N, V>& f) { return have_sign(f.p, 1, Zero::fails); }

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

  template <std::size_t V>
  static Polynomial<Ball, V, 1> root_bound(bool from_above, const Polynomial<Ball, V, 2>& p);

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

/// A linear bound of sqrt(P/54), with infinite errors if there is none: from above by convexity; from
/// below by Cauchy's inequality, tr(M E) for any E with 54 tr(E^2) < 1, here the corners' mean.
template <std::size_t V>
Polynomial<Ball, V, 1> ModeRule::root_bound(bool from_above, const Polynomial<Ball, V, 2>& p) {
  static constexpr auto places = product_table<V, 1, 1>();
  Polynomial<Ball, V, 1> s;
  Ball square, room(1);  // tr(E^2) up to a factor; what is to be positive
  std::array<double, V> roots{};
  for (std::size_t i = 0; i < V; ++i) roots[i] = std::sqrt(p.coefficients[places[i][i]].value);
  for (std::size_t i = 0; i < V && !from_above; ++i) {
    for (std::size_t j = 0; j < V; ++j)
      s.coefficients[i] += Ball((i == j ? 1 : 0.5) / roots[j], 0) * p.coefficients[places[i][j]];
    square += Ball(1 / roots[i], 0) * s.coefficients[i];
  }
  const Ball factor((1 - 0x1p-40) / std::sqrt(54 * square.value), 0);
  if (!from_above) room -= Ball(54) * factor * factor * square;
  for (std::size_t i = 0; i < V; ++i) {
    Ball& x = s.coefficients[i];
    x = from_above ? Ball((1 + 0x1p-40) * roots[i] / std::sqrt(54.0), 0) : factor * x;
    if (from_above) room = Ball(54) * x * x - p.coefficients[places[i][i]];
    if (has_sign(room, 1, Zero::fails) != Answer::yes) x.error = HUGE_VAL;
  }
  return s;
}

}  // namespace certificate
