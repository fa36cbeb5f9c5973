// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/theory/check.hpp"

#include <stdexcept>

namespace tensortopo::theory {
namespace {

template <class Scalar, class Function>
Outcome outcome_of(const Function& function, const Trial& trial, Mutation mutation) {
  Facts<Scalar> facts(mutation);
  try {
    function(trial, facts);
  } catch (const std::overflow_error&) {
    // What rational numbers say to a denominator that is zero: a formula without a value.
    facts.about({});
    facts.holds("a denominator other than zero", false);
  }
  return facts.outcome();
}

}  // namespace

Outcome Check::operator()(const Trial& trial, Arithmetic arithmetic, Mutation mutation) const {
  switch (arithmetic) {
    case Arithmetic::rational:
      return outcome_of<Rational>(rational_, trial, mutation);
    case Arithmetic::interval:
      return outcome_of<Interval>(interval_, trial, mutation);
    case Arithmetic::real100:
      return outcome_of<Bounded100>(real100_, trial, mutation);
    case Arithmetic::real53:
      break;
  }
  return outcome_of<Bounded53>(real53_, trial, mutation);
}

std::size_t Check::constants(const Trial& trial) const {
  Facts<Rational> facts;
  rational_(trial, facts);
  return facts.constants();
}

}  // namespace tensortopo::theory
