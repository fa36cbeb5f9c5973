// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Where the magnitude, the deviator's, or the anisotropy is greater than a value: the sign of one
// quadratic form.
#pragma once

#include "forms.hpp"

namespace certificate {

enum class Invariant : unsigned char { magnitude, deviator_magnitude, anisotropy };

/// Which multiples of a tensor's parts a level is about: of all of it, of the number one.
struct Multiples {
  mpz_class tensor = 1;
  bool trace = false;
  mpz_class one = 0;

  friend bool operator==(const Multiples&, const Multiples&) = default;
};

/// p tr(M^2) + t^2 (trace) + h^2 (one), on a simplex.
template <class N, std::size_t V>
struct QuadraticForm {
  Polynomial<N, V, 2> q;
};
/// Of the sign of the form's derivative along d.
template <class N, std::size_t V>
Polynomial<N, V, 1> increase(const QuadraticForm<N, V>& f, const std::array<int, V>& d) {
  return derivative(f.q, d);
}

/// With M three times the deviator, P = tr(M^2) and t the trace, |T| > v where P + 3 t^2 > 9 v^2,
/// |D| > v where P > 9 v^2, and |D| > v |T| where (1 - v^2) P > 3 v^2 t^2. For v = m/n the first
/// two are of (n M, n t, 3 m), the last one of (M, t, 0).
class InvariantRule {
 public:
  /// @pre 0 < value, and < 1 for an anisotropy
  InvariantRule(Invariant invariant, const mpq_class& value) {
    const mpz_class &m = value.get_num(), &n = value.get_den();
    if (invariant == Invariant::anisotropy) {
      multiples_ = {1, true, 0};
      exact_ = {n * n - m * m, -3 * m * m, 0};
    } else {
      multiples_ = {n, invariant == Invariant::magnitude, 3 * m};
      exact_ = {1, 3, -1};
    }
    for (std::size_t i = 0; i < 3; ++i) balls_[i] = scaled(exact_[i], exact_[1]);
  }
  const Multiples& multiples() const { return multiples_; }
  double tube() const { return 1; }

  template <class N, std::size_t V>
  QuadraticForm<N, V> forms(const std::array<const Tensor<N>*, V>& tensors) const {
    const auto factor = [&](std::size_t i) -> N {
      if constexpr (std::is_same_v<N, mpz_class>) return exact_[i];
      else if constexpr (std::is_same_v<N, Ball>) return balls_[i];
      else return balls_[i].value;
    };
    return {quadratic<N, V>(tensors, [&](const Tensor<N>& m, const Tensor<N>& k) {
      return N(factor(0) * trace(m, k) + factor(1) * m[6] * k[6] + factor(2) * m[7] * k[7]);
    })};
  }
  /// Is all of the simplex on this side? Points exactly on the level are below.
  template <class N, std::size_t V>
  Answer lies(bool above, const QuadraticForm<N, V>& f) const {
    return have_sign(f.q, above ? 1 : -1, above ? Zero::fails : Zero::will_do);
  }
  static double reach(const QuadraticForm<Ball, 1>&) { return HUGE_VAL; }
  template <std::size_t V>
  static bool lies_by_norm(bool, const QuadraticForm<Ball, V>&) { return false; }
  template <std::size_t V>
  static auto rise(const QuadraticForm<Ball, V>& f) {
    return [&f](const std::array<int, V>& d) { return std::array{increase(f, d)}; };
  }
  template <class N>
  Answer is_on(const QuadraticForm<N, 1>& f) const {
    return is_zero(f.q);
  }
  template <class N, std::size_t V>
  static Answer is_defined(const QuadraticForm<N, V>&) {
    return Answer::yes;
  }

 private:
  Multiples multiples_;
  std::array<mpz_class, 3> exact_;  ///< factors of tr(M^2), t^2, h^2
  std::array<Ball, 3> balls_;       ///< divided by one positive number
};

}  // namespace certificate
