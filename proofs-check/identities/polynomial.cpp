// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "polynomial.hpp"

namespace identities {

Polynomial::Polynomial(const mpq_class& constant) { add({}, constant); }

Polynomial Polynomial::variable(const std::string& name) {
  Polynomial f;
  f.add({{name, 1U}}, 1);
  return f;
}

void Polynomial::add(const Monomial& monomial, const mpq_class& coefficient) {
  if (coefficient == 0) return;
  const auto [entry, is_new] = terms_.try_emplace(monomial, coefficient);
  if (is_new) return;
  entry->second += coefficient;
  if (entry->second == 0) terms_.erase(entry);
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  if (&other == this) return *this = *this * Polynomial(2);
  for (const auto& [monomial, coefficient] : other.terms_) add(monomial, coefficient);
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& other) {
  if (&other == this) return *this = Polynomial();
  for (const auto& [monomial, coefficient] : other.terms_) add(monomial, -coefficient);
  return *this;
}

Polynomial operator*(const Polynomial& f, const Polynomial& g) {
  Polynomial result;
  for (const auto& [left, a] : f.terms_)
    for (const auto& [right, b] : g.terms_) {
      Polynomial::Monomial product = left;
      for (const auto& [name, exponent] : right) product[name] += exponent;
      result.add(product, a * b);
    }
  return result;
}

Polynomial Polynomial::derivative(const std::string& name) const {
  Polynomial result;
  for (const auto& [monomial, coefficient] : terms_) {
    Monomial lowered = monomial;
    const auto factor = lowered.find(name);
    if (factor == lowered.end()) continue;
    const mpq_class exponent(factor->second);
    if (--factor->second == 0) lowered.erase(factor);
    result.add(lowered, coefficient * exponent);
  }
  return result;
}

Polynomial Polynomial::with_square(const std::string& name, const Polynomial& square) const {
  Polynomial result;
  for (const auto& [monomial, coefficient] : terms_) {
    Monomial rest = monomial;
    const auto factor = rest.find(name);
    unsigned squares = 0;
    if (factor != rest.end()) {
      squares = factor->second / 2;
      factor->second %= 2;
      if (factor->second == 0) rest.erase(factor);
    }
    Polynomial term;
    term.add(rest, coefficient);
    result += term * power(square, squares);
  }
  return result;
}

Polynomial power(const Polynomial& f, unsigned exponent) {
  Polynomial result(1);
  for (unsigned i = 0; i < exponent; ++i) result = result * f;
  return result;
}

}  // namespace identities
