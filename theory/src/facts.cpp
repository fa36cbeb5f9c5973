// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/theory/facts.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo::theory {

void FactsBase::violate(std::string_view what) {
  if (outcome_.kind != Outcome::Kind::holds) return;
  std::string configuration = std::move(outcome_.configuration);
  outcome_ = Outcome::violated(std::string(what) + (place_ ? ": " + place_() : std::string()));
  outcome_.configuration = std::move(configuration);
}

void FactsBase::undecided(std::string why) {
  if (outcome_.kind != Outcome::Kind::holds) return;
  std::string configuration = std::move(outcome_.configuration);
  outcome_ = Outcome::undecided(std::move(why));
  outcome_.configuration = std::move(configuration);
}

void FactsBase::leave_open(std::string_view what, double reach) {
  if (!open_.empty() && !(reach > reach_ || std::isnan(reach))) return;
  open_ = what;
  reach_ = reach;
}

void FactsBase::configuration(const std::vector<Rational>& numbers) {
  outcome_.configuration.clear();
  for (const Rational& q : numbers) outcome_.configuration += q.str() + ' ';
}

void FactsBase::configuration_of(const TetrahedronField<Rational>& field,
                                 const std::vector<Rational>& numbers) {
  std::vector<Rational> all = invariants(field);
  all.insert(all.end(), numbers.begin(), numbers.end());
  configuration(all);
}

Outcome FactsBase::outcome() const {
  if (outcome_.kind != Outcome::Kind::holds || open_.empty()) return outcome_;
  char bound[32];
  std::snprintf(bound, sizeof bound, "%.1e", reach_);
  Outcome open =
      Outcome::undecided(open_ + " is open: within " + bound + " of 0 in these numbers", reach_);
  open.configuration = outcome_.configuration;
  return open;
}

std::vector<Rational> invariants(const TetrahedronField<Rational>& field) {
  std::array<SymmetricTensor<Rational>, 4> t;
  Rational size(0);
  for (std::size_t i = 0; i < 4; ++i) {
    t[i] = to_tensor(field.vertex[i]);
    size = size + inner(t[i], t[i]);
  }
  if (size == 0) return {size};
  std::vector<Rational> result;
  // Cubic ones with their sign, as squares: the scale may be a root.
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j) {
      result.push_back(Rational(inner(t[i], t[j]) / size));
      const auto product = square(t[i] + t[j]) - square(t[i]) - square(t[j]);
      for (std::size_t k = j; k < 4; ++k) {
        const Rational cubic = inner(product, t[k]);
        const Rational squared = cubic * cubic / (size * size * size);
        result.push_back(cubic < 0 ? Rational(-squared) : squared);
      }
    }
  return result;
}

}  // namespace tensortopo::theory
