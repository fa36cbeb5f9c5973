// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <flint/fmpz_poly.h>

#include "integer.hpp"
#include "tensortopo/scalar/sign.hpp"

namespace tensortopo::theory {

/// A polynomial in one variable with integer coefficients; a scalar for tensors and vectors too.
class Polynomial {
 public:
  Polynomial() { fmpz_poly_init(value_); }
  Polynomial(int constant) : Polynomial() { fmpz_poly_set_si(value_, constant); }
  explicit Polynomial(const Integer& constant) : Polynomial() { set_coefficient(0, constant); }
  Polynomial(const Polynomial& other) : Polynomial() { fmpz_poly_set(value_, other.value_); }
  Polynomial(Polynomial&& other) noexcept : Polynomial() { fmpz_poly_swap(value_, other.value_); }
  Polynomial& operator=(Polynomial other) noexcept {
    fmpz_poly_swap(value_, other.value_);
    return *this;
  }
  ~Polynomial() { fmpz_poly_clear(value_); }

  /// The variable itself.
  static Polynomial variable();

  void set_coefficient(int power, const Integer& coefficient);
  /// -1 for the zero polynomial.
  int degree() const { return static_cast<int>(fmpz_poly_degree(value_)); }
  bool is_zero() const { return fmpz_poly_is_zero(value_) != 0; }
  Integer coefficient(int power) const;
  Sign sign_at(const Rational& x) const;
  /// The sign for arguments beyond all real zeros.
  Sign sign_at_infinity() const;
  Rational value_at(const Rational& x) const;
  /// The sum of |coefficient| power x^(power - 1): no derivative is larger in [-x, x].
  Rational steepest_within(const Rational& x) const;

  friend Polynomial operator+(const Polynomial& p, const Polynomial& q);
  friend Polynomial operator-(const Polynomial& p, const Polynomial& q);
  friend Polynomial operator-(const Polynomial& p);
  friend Polynomial operator*(const Polynomial& p, const Polynomial& q);
  friend bool operator==(const Polynomial& p, const Polynomial& q) {
    return fmpz_poly_equal(p.value_, q.value_) != 0;
  }

  friend Polynomial derivative(const Polynomial& p);
  /// Over the rationals, with coprime integer coefficients.
  friend Polynomial greatest_common_divisor(const Polynomial& p, const Polynomial& q);
  /// Whether p = q times a polynomial with rational coefficients. Requires q nonzero.
  friend bool divides(const Polynomial& q, const Polynomial& p);
  /// p / q with coprime coefficients and of the sign of p q. Requires that q divides p, both
  /// nonzero.
  friend Polynomial quotient(const Polynomial& p, const Polynomial& q);
  /// No repeated complex zero. Requires p nonzero.
  friend bool is_squarefree(const Polynomial& p);
  /// A positive multiple of the remainder of p by q. Requires q nonzero.
  friend Polynomial remainder(const Polynomial& p, const Polynomial& q);
  /// The greatest common divisor of the coefficients, not negative.
  friend Integer content(const Polynomial& p);
  /// Requires that k divides every coefficient.
  friend Polynomial exact_quotient(const Polynomial& p, const Integer& k);

 private:
  Polynomial primitive() const;

  fmpz_poly_t value_;
};

}  // namespace tensortopo::theory
