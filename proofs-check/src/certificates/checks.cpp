// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "certificates/checks.hpp"

#include <algorithm>

#include "algebra/hypotheses.hpp"
#include "algebra/univariate.hpp"

namespace proofs {
namespace {

/// Long polynomials are cut: the reason is for people.
std::string shortened(const Polynomial& f) {
  constexpr std::size_t longest = 160;
  const std::string text = f.text();
  return text.size() <= longest ? text : text.substr(0, longest) + " ..";
}

}  // namespace

Checks::Outcome Checks::outcome() const { return asserted_ ? worst_ : Outcome::undecided; }

void Checks::note(Outcome outcome, const std::string& reason) {
  asserted_ = true;
  if (outcome == Outcome::proved) return;
  if (reason_.empty()) reason_ = reason;
  // A refutation outweighs what is merely undecided.
  if (worst_ != Outcome::refuted) worst_ = outcome;
}

void Checks::vanishes(const Polynomial& f) {
  if (f.is_zero()) return note(Outcome::proved, {});
  note(Outcome::refuted, "not zero: " + shortened(f));
}

void Checks::all_vanish(const std::vector<Polynomial>& all) {
  for (const Polynomial& f : all) vanishes(f);
}

void Checks::differ(const Polynomial& f, const Polynomial& g) {
  that(!(f - g).is_zero(), "the two sides are equal: " + shortened(f));
}

void Checks::that(bool fact, const std::string& what) {
  note(fact ? Outcome::proved : Outcome::refuted, what);
}

void Checks::is_positive(const Polynomial& number) {
  that(number.constant() > 0, "not positive: " + number.text());
}

void Checks::positive_on_orthant(const Polynomial& f) {
  const std::vector<Rational> all = f.coefficients();
  const auto positives =
      std::count_if(all.begin(), all.end(), [](const Rational& c) { return c > 0; });
  if (positives == static_cast<std::ptrdiff_t>(all.size()) && positives > 0)
    return note(Outcome::proved, {});
  note(positives == 0 ? Outcome::refuted : Outcome::undecided,
       "not all coefficients are positive: " + shortened(f));
}

void Checks::sum_of_squares(const Polynomial& f, const std::vector<WeightedSquare>& squares) {
  Polynomial sum;
  for (const auto& [weight, root] : squares) {
    sum += weight * square(root);
    that(weight.constant() >= 0, "a negative weight: " + weight.text());
  }
  equal(f, sum);
}

void Checks::positive_on(const Polynomial& f, const Interval& interval) {
  const auto& [name, least, most] = interval;
  // Without the hypothesis: an interval far beyond both ends.
  const bool inside = Hypotheses::use(name + " in an interval");
  const Rational low = inside ? least : Rational(least - 1000),
                 high = inside ? most : Rational(most + 1000);
  that(low < high, "an empty interval");
  that(f.with(name, Rational((low + high) / 2)).constant() > 0,
       "not positive in the middle of the interval: " + shortened(f));
  that(count_roots(f, name, low, high) == 0, "has a root in the interval: " + shortened(f));
}

}  // namespace proofs
