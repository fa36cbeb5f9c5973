// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <flint/fmpq_mpoly.h>
#include <gmpxx.h>

#include <string>
#include <utility>
#include <vector>

namespace proofs {

using Rational = mpq_class;

/// A quotient in lowest terms.
inline Rational rational(long numerator, long denominator = 1) {
  Rational value(numerator, denominator);
  value.canonicalize();
  return value;
}

/// A polynomial with rational coefficients in named variables, fully expanded: FLINT's sparse
/// normal form, so two polynomials are equal exactly if their difference has no term.
///
/// All share one context; a name takes the next of its variables when it is first used.
/// Not for several threads at a time.
class Polynomial {
 public:
  Polynomial();
  Polynomial(const Rational& constant);
  Polynomial(int constant) : Polynomial(Rational(constant)) {}
  Polynomial(const Polynomial& other);
  Polynomial(Polynomial&& other) noexcept;
  Polynomial& operator=(const Polynomial& other);
  Polynomial& operator=(Polynomial&& other) noexcept;
  ~Polynomial();
  static Polynomial variable(const std::string& name);

  bool is_zero() const;
  bool is_constant() const;
  /// Throws std::domain_error unless it is constant.
  Rational constant() const;
  /// In all variables together. Zero for the zero polynomial.
  long total_degree() const;
  /// Of all terms.
  std::vector<Rational> coefficients() const;
  /// The factors of the powers of a variable, from power 0 to the degree.
  std::vector<Polynomial> coefficients_of(const std::string& name) const;
  /// For people, in an unspecified order.
  std::string text() const;

  Polynomial& operator+=(const Polynomial& other);
  Polynomial& operator-=(const Polynomial& other);
  friend Polynomial operator+(Polynomial f, const Polynomial& g) { return std::move(f += g); }
  friend Polynomial operator-(Polynomial f, const Polynomial& g) { return std::move(f -= g); }
  friend Polynomial operator-(const Polynomial& f) { return Polynomial() - f; }
  friend Polynomial operator*(const Polynomial& f, const Polynomial& g);
  /// f / g. Throws std::domain_error unless g divides f.
  friend Polynomial exact_quotient(const Polynomial& f, const Polynomial& g);
  friend Polynomial resultant(const Polynomial& f, const Polynomial& g, const std::string& name);

  /// The partial derivative.
  Polynomial derivative(const std::string& name) const;
  /// With a polynomial in the place of a variable.
  Polynomial with(const std::string& name, const Polynomial& value) const;
  /// The remainder after replacing the square of a variable, as often as it occurs, by a polynomial
  /// without that variable. For relations r_1^2 = g_1, r_2^2 = g_2, .. in which g_i holds none of
  /// r_1 .. r_i, doing so in this order gives a normal form modulo the relations.
  Polynomial with_square(const std::string& name, const Polynomial& square) const;

 private:
  fmpq_mpoly_t value_;
};

inline Polynomial variable(const std::string& name) { return Polynomial::variable(name); }
Polynomial power(const Polynomial& f, unsigned exponent);
inline Polynomial square(const Polynomial& f) { return f * f; }
inline Polynomial cube(const Polynomial& f) { return f * f * f; }

}  // namespace proofs
