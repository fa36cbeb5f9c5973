// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/univariate.hpp"

#include <flint/fmpq_poly.h>

#include <stdexcept>

#include "algebra/flint_rational.hpp"

namespace proofs {
namespace {

class Univariate {
 public:
  Univariate() { fmpq_poly_init(value_); }
  Univariate(const Univariate& other) : Univariate() { fmpq_poly_set(value_, other.value_); }
  Univariate& operator=(const Univariate& other) {
    fmpq_poly_set(value_, other.value_);
    return *this;
  }
  ~Univariate() { fmpq_poly_clear(value_); }
  Univariate(const Polynomial& f, const std::string& name) : Univariate() {
    if (f.is_zero()) throw std::domain_error("the zero polynomial has no number of roots");
    const auto powers = f.coefficients_of(name);
    for (std::size_t i = 0; i < powers.size(); ++i)
      fmpq_poly_set_coeff_fmpq(value_, static_cast<slong>(i),
                               FlintRational(powers[i].constant()).get());
  }

  fmpq_poly_struct* get() { return value_; }
  const fmpq_poly_struct* get() const { return value_; }
  bool is_zero() const { return fmpq_poly_is_zero(value_) != 0; }
  int sign_at(const Rational& x) const {
    FlintRational result;
    fmpq_poly_evaluate_fmpq(result.get(), value_, FlintRational(x).get());
    return fmpq_sgn(result.get());
  }
  Univariate derivative() const {
    Univariate result;
    fmpq_poly_derivative(result.value_, value_);
    return result;
  }

 private:
  fmpq_poly_t value_;
};

Univariate square_free_part(const Univariate& f) {
  Univariate common, part;
  fmpq_poly_gcd(common.get(), f.get(), f.derivative().get());
  fmpq_poly_div(part.get(), f.get(), common.get());
  return part;
}

/// f, f', and each next one the negative of the remainder of the two before it.
std::vector<Univariate> sturm_sequence(const Univariate& f) {
  std::vector<Univariate> sequence{f};
  for (Univariate next = f.derivative(); !next.is_zero();) {
    sequence.push_back(next);
    fmpq_poly_rem(next.get(), sequence[sequence.size() - 2].get(), sequence.back().get());
    fmpq_poly_neg(next.get(), next.get());
  }
  return sequence;
}

long sign_changes(const std::vector<Univariate>& sequence, const Rational& x) {
  long changes = 0;
  int last = 0;
  for (const Univariate& f : sequence) {
    const int sign = f.sign_at(x);
    if (sign != 0 && last != 0 && sign != last) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

}  // namespace

long count_roots(const Polynomial& f, const std::string& name, const Rational& low,
                 const Rational& high) {
  const Univariate part = square_free_part(Univariate(f, name));
  const std::vector<Univariate> sequence = sturm_sequence(part);
  // The sequence counts roots in (low, high].
  return sign_changes(sequence, low) - sign_changes(sequence, high) -
         (part.sign_at(high) == 0 ? 1 : 0);
}

long count_complex_roots(const Polynomial& f, const std::string& name) {
  return fmpq_poly_degree(square_free_part(Univariate(f, name)).get());
}

long count_common_roots(const Polynomial& f, const Polynomial& g, const std::string& name) {
  Univariate common;
  fmpq_poly_gcd(common.get(), Univariate(f, name).get(), Univariate(g, name).get());
  return fmpq_poly_degree(square_free_part(common).get());
}

}  // namespace proofs
