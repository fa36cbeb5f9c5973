// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/polynomial.hpp"

#include <flint/fmpq.h>

namespace tensortopo::theory {
namespace {

// Numbers of FLINT's for the time of one call.
struct Number {
  Number() { fmpz_init(value); }
  explicit Number(const Integer& integer) : Number() {
    fmpz_set_mpz(value, integer.backend().data());
  }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  ~Number() { fmpz_clear(value); }

  fmpz_t value;
};

struct Fraction {
  explicit Fraction(const Rational& x) {
    fmpq_init(value);
    fmpq_set_mpq(value, x.backend().data());
  }
  Fraction(const Fraction&) = delete;
  Fraction& operator=(const Fraction&) = delete;
  ~Fraction() { fmpq_clear(value); }

  fmpq_t value;
};

}  // namespace

Polynomial Polynomial::variable() {
  Polynomial x;
  fmpz_poly_set_coeff_si(x.value_, 1, 1);
  return x;
}

void Polynomial::set_coefficient(int power, const Integer& coefficient) {
  const Number number(coefficient);
  fmpz_poly_set_coeff_fmpz(value_, power, number.value);
}

Integer Polynomial::coefficient(int power) const {
  Number number;
  fmpz_poly_get_coeff_fmpz(number.value, value_, power);
  Integer result;
  fmpz_get_mpz(result.backend().data(), number.value);
  return result;
}

Sign Polynomial::sign_at(const Rational& x) const {
  Fraction argument(x);
  fmpz_poly_evaluate_fmpq(argument.value, value_, argument.value);
  return static_cast<Sign>(fmpq_sgn(argument.value));
}

Rational Polynomial::value_at(const Rational& x) const {
  Fraction argument(x);
  fmpz_poly_evaluate_fmpq(argument.value, value_, argument.value);
  Rational result;
  fmpq_get_mpq(result.backend().data(), argument.value);
  return result;
}

Rational Polynomial::steepest_within(const Rational& x) const {
  Polynomial bound = derivative(*this);
  for (slong i = 0; i < fmpz_poly_length(bound.value_); ++i) {
    fmpz* coefficient = fmpz_poly_get_coeff_ptr(bound.value_, i);
    fmpz_abs(coefficient, coefficient);
  }
  return bound.value_at(abs(x));
}

Sign Polynomial::sign_at_infinity() const {
  return is_zero() ? Sign::zero : static_cast<Sign>(fmpz_sgn(fmpz_poly_lead(value_)));
}

Polynomial operator+(const Polynomial& p, const Polynomial& q) {
  Polynomial sum;
  fmpz_poly_add(sum.value_, p.value_, q.value_);
  return sum;
}

Polynomial operator-(const Polynomial& p, const Polynomial& q) {
  Polynomial difference;
  fmpz_poly_sub(difference.value_, p.value_, q.value_);
  return difference;
}

Polynomial operator-(const Polynomial& p) {
  Polynomial negative;
  fmpz_poly_neg(negative.value_, p.value_);
  return negative;
}

Polynomial operator*(const Polynomial& p, const Polynomial& q) {
  Polynomial product;
  fmpz_poly_mul(product.value_, p.value_, q.value_);
  return product;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial result;
  fmpz_poly_derivative(result.value_, p.value_);
  return result;
}

Integer content(const Polynomial& p) {
  Number number;
  fmpz_poly_content(number.value, p.value_);
  Integer result;
  fmpz_get_mpz(result.backend().data(), number.value);
  return result;
}

Polynomial exact_quotient(const Polynomial& p, const Integer& k) {
  Polynomial result;
  const Number number(k);
  fmpz_poly_scalar_divexact_fmpz(result.value_, p.value_, number.value);
  return result;
}

// Divided by the greatest common divisor of its coefficients.
Polynomial Polynomial::primitive() const {
  return is_zero() ? Polynomial() : exact_quotient(*this, content(*this));
}

Polynomial greatest_common_divisor(const Polynomial& p, const Polynomial& q) {
  Polynomial divisor;
  fmpz_poly_gcd(divisor.value_, p.value_, q.value_);
  return divisor.primitive();
}

bool divides(const Polynomial& q, const Polynomial& p) { return remainder(p, q).is_zero(); }

Polynomial quotient(const Polynomial& p, const Polynomial& q) {
  // By Gauss's lemma a quotient of primitive polynomials is one of integer coefficients.
  const Polynomial dividend = p.primitive(), divisor = q.primitive();
  Polynomial result;
  fmpz_poly_div(result.value_, dividend.value_, divisor.value_);
  return result;
}

bool is_squarefree(const Polynomial& p) {
  return greatest_common_divisor(p, derivative(p)).degree() <= 0;
}

Polynomial remainder(const Polynomial& p, const Polynomial& q) {
  Polynomial rest;
  ulong power = 0;
  fmpz_poly_pseudo_rem(rest.value_, &power, p.value_, q.value_);
  // It is the remainder times this power of the leading coefficient of q.
  const bool flip = power % 2 == 1 && q.sign_at_infinity() == Sign::negative;
  return (flip ? -rest : rest).primitive();
}

}  // namespace tensortopo::theory
