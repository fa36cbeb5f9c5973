// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/polynomial.hpp"

#include <algorithm>
#include <stdexcept>

#include "algebra/flint_rational.hpp"
#include "algebra/hypotheses.hpp"

namespace proofs {
namespace {

/// The variables of all polynomials. Fewer would make products faster: the time of a product grows
/// with the number of words that the exponents of a term take.
class Context {
 public:
  Context() { fmpq_mpoly_ctx_init(context_, capacity, ORD_LEX); }
  ~Context() { fmpq_mpoly_ctx_clear(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  slong index(const std::string& name) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end()) return static_cast<slong>(found - names_.begin());
    if (static_cast<slong>(names_.size()) == capacity)
      throw std::length_error("no variable is left for " + name);
    names_.push_back(name);
    return static_cast<slong>(names_.size()) - 1;
  }
  const std::vector<std::string>& names() const { return names_; }
  operator const fmpq_mpoly_ctx_struct*() const { return context_; }

 private:
  static constexpr slong capacity = 160;
  fmpq_mpoly_ctx_t context_;
  std::vector<std::string> names_;
};

Context& context() {
  static Context shared;
  return shared;
}

}  // namespace

Polynomial::Polynomial() { fmpq_mpoly_init(value_, context()); }
Polynomial::Polynomial(const Rational& constant) : Polynomial() {
  fmpq_mpoly_set_fmpq(value_, FlintRational(constant).get(), context());
}
Polynomial::Polynomial(const Polynomial& other) : Polynomial() {
  fmpq_mpoly_set(value_, other.value_, context());
}
Polynomial::Polynomial(Polynomial&& other) noexcept : Polynomial() {
  fmpq_mpoly_swap(value_, other.value_, context());
}
Polynomial& Polynomial::operator=(const Polynomial& other) {
  fmpq_mpoly_set(value_, other.value_, context());
  return *this;
}
Polynomial& Polynomial::operator=(Polynomial&& other) noexcept {
  fmpq_mpoly_swap(value_, other.value_, context());
  return *this;
}
Polynomial::~Polynomial() { fmpq_mpoly_clear(value_, context()); }

Polynomial Polynomial::variable(const std::string& name) {
  Polynomial f;
  fmpq_mpoly_gen(f.value_, context().index(name), context());
  return f;
}

bool Polynomial::is_zero() const { return fmpq_mpoly_is_zero(value_, context()) != 0; }
bool Polynomial::is_constant() const { return fmpq_mpoly_is_fmpq(value_, context()) != 0; }

Rational Polynomial::constant() const {
  if (!is_constant()) throw std::domain_error("not a number: " + text());
  FlintRational value;
  fmpq_mpoly_get_fmpq(value.get(), value_, context());
  return value.rational();
}

long Polynomial::total_degree() const {
  return std::max(0L, static_cast<long>(fmpq_mpoly_total_degree_si(value_, context())));
}

std::vector<Rational> Polynomial::coefficients() const {
  std::vector<Rational> all;
  FlintRational coefficient;
  for (slong i = 0; i < fmpq_mpoly_length(value_, context()); ++i) {
    fmpq_mpoly_get_term_coeff_fmpq(coefficient.get(), value_, i, context());
    all.push_back(coefficient.rational());
  }
  return all;
}

std::vector<Polynomial> Polynomial::coefficients_of(const std::string& name) const {
  const slong index = context().index(name);
  const slong degree = std::max<slong>(0, fmpq_mpoly_degree_si(value_, index, context()));
  std::vector<Polynomial> all(static_cast<std::size_t>(degree) + 1);
  fmpq_mpoly_univar_t powers;
  fmpq_mpoly_univar_init(powers, context());
  fmpq_mpoly_to_univar(powers, value_, index, context());
  for (slong i = 0; i < fmpq_mpoly_univar_length(powers, context()); ++i) {
    const slong exponent = fmpq_mpoly_univar_get_term_exp_si(powers, i, context());
    fmpq_mpoly_univar_get_term_coeff(all[static_cast<std::size_t>(exponent)].value_, powers, i,
                                     context());
  }
  fmpq_mpoly_univar_clear(powers, context());
  return all;
}

std::string Polynomial::text() const {
  std::vector<std::string> names = context().names();
  while (static_cast<slong>(names.size()) < fmpq_mpoly_ctx_nvars(context())) names.emplace_back();
  std::vector<const char*> pointers;
  for (const std::string& name : names) pointers.push_back(name.c_str());
  char* raw = fmpq_mpoly_get_str_pretty(value_, pointers.data(), context());
  std::string result(raw);
  flint_free(raw);
  return result;
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  fmpq_mpoly_add(value_, value_, other.value_, context());
  return *this;
}
Polynomial& Polynomial::operator-=(const Polynomial& other) {
  fmpq_mpoly_sub(value_, value_, other.value_, context());
  return *this;
}
Polynomial operator*(const Polynomial& f, const Polynomial& g) {
  Polynomial product;
  fmpq_mpoly_mul(product.value_, f.value_, g.value_, context());
  return product;
}

Polynomial exact_quotient(const Polynomial& f, const Polynomial& g) {
  Polynomial quotient;
  if (g.is_zero() || fmpq_mpoly_divides(quotient.value_, f.value_, g.value_, context()) == 0)
    throw std::domain_error(g.text() + " does not divide " + f.text());
  return quotient;
}

Polynomial resultant(const Polynomial& f, const Polynomial& g, const std::string& name) {
  Polynomial result;
  const slong index = context().index(name);
  if (fmpq_mpoly_resultant(result.value_, f.value_, g.value_, index, context()) == 0)
    throw std::domain_error("FLINT gives no resultant");
  return result;
}

Polynomial Polynomial::derivative(const std::string& name) const {
  Polynomial result;
  fmpq_mpoly_derivative(result.value_, value_, context().index(name), context());
  return result;
}

Polynomial Polynomial::with(const std::string& name, const Polynomial& value) const {
  const std::vector<Polynomial> powers = coefficients_of(name);
  Polynomial result;
  for (auto power = powers.rbegin(); power != powers.rend(); ++power)
    result = result * value + *power;
  return result;
}

Polynomial Polynomial::with_square(const std::string& name, const Polynomial& square) const {
  const std::vector<Polynomial> powers = coefficients_of(name);
  if (powers.size() < 3 || !Hypotheses::use(name + "^2 = ..")) return *this;
  Polynomial even, odd;
  for (std::size_t i = powers.size(); i-- > 0;) {
    Polynomial& part = i % 2 == 0 ? even : odd;
    part = part * square + powers[i];
  }
  return even + odd * variable(name);
}

Polynomial power(const Polynomial& f, unsigned exponent) {
  Polynomial result(1);
  for (unsigned i = 0; i < exponent; ++i) result = result * f;
  return result;
}

}  // namespace proofs
