// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/theory/facts.hpp"

#include <cmath>
#include <cstdio>

namespace tensortopo::theory {

void FactsBase::violate(std::string_view what) {
  if (outcome_.kind != Outcome::Kind::holds) return;
  outcome_ = Outcome::violated(std::string(what) + (place_ ? ": " + place_() : std::string()));
}

void FactsBase::undecided(std::string why) {
  if (outcome_.kind == Outcome::Kind::holds) outcome_ = Outcome::undecided(std::move(why));
}

void FactsBase::leave_open(std::string_view what, double reach) {
  if (!open_.empty() && !(reach > reach_ || std::isnan(reach))) return;
  open_ = what;
  reach_ = reach;
}

Outcome FactsBase::outcome() const {
  if (outcome_.kind != Outcome::Kind::holds || open_.empty()) return outcome_;
  char bound[32];
  std::snprintf(bound, sizeof bound, "%.1e", reach_);
  return Outcome::undecided(open_ + " is open: within " + bound + " of 0 in these numbers", reach_);
}

}  // namespace tensortopo::theory
