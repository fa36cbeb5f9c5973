// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <map>
#include <string>

namespace identities {

/// A polynomial with rational coefficients in any number of named variables, fully expanded.
///
/// Normal form: one entry for each monomial with a nonzero coefficient, so two polynomials are
/// equal exactly if their difference has no entry.
class Polynomial {
 public:
  /// Exponents, none of them zero.
  using Monomial = std::map<std::string, unsigned>;

  Polynomial() = default;
  Polynomial(const mpq_class& constant);
  Polynomial(int constant) : Polynomial(mpq_class(constant)) {}
  static Polynomial variable(const std::string& name);

  bool is_zero() const { return terms_.empty(); }

  Polynomial& operator+=(const Polynomial& other);
  Polynomial& operator-=(const Polynomial& other);
  friend Polynomial operator+(Polynomial f, const Polynomial& g) { return f += g; }
  friend Polynomial operator-(Polynomial f, const Polynomial& g) { return f -= g; }
  friend Polynomial operator-(const Polynomial& f) { return Polynomial() - f; }
  friend Polynomial operator*(const Polynomial& f, const Polynomial& g);

  /// The partial derivative.
  Polynomial derivative(const std::string& name) const;

  /// The remainder after replacing the square of a variable, as often as it occurs, by a polynomial
  /// without that variable. For relations r_1^2 = g_1, r_2^2 = g_2, .. in which g_i holds none of
  /// r_1 .. r_i, doing so in this order gives a normal form modulo the relations.
  Polynomial with_square(const std::string& name, const Polynomial& square) const;

 private:
  void add(const Monomial& monomial, const mpq_class& coefficient);

  std::map<Monomial, mpq_class> terms_;
};

Polynomial power(const Polynomial& f, unsigned exponent);
inline Polynomial square(const Polynomial& f) { return f * f; }
inline Polynomial cube(const Polynomial& f) { return f * f * f; }

}  // namespace identities
