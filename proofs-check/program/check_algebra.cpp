// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What the steps compute with, on cases whose answers are known; also that what is false is not
// proved. Exit status: 0 all is right, 1 something is not.
#include <algorithm>
#include <iostream>

#include "algebra/univariate.hpp"
#include "certificates/checks.hpp"
#include "proof_steps/steps.hpp"

namespace {

using namespace proofs;

int failures = 0;

void expect(bool fact, const char* what) {
  if (fact) return;
  ++failures;
  std::cout << "wrong: " << what << '\n';
}

void check_polynomials() {
  const auto x = variable("x"), y = variable("y"), r = variable("r");
  const Polynomial f = square(x + y) - square(x - y);
  expect((f - Polynomial(4) * x * y).is_zero(), "(x+y)^2 - (x-y)^2 = 4 x y");
  expect(!(f - Polynomial(3) * x * y).is_zero(), "and not 3 x y");
  expect(f.coefficients() == std::vector<Rational>{4}, "one coefficient, 4");
  expect(f.total_degree() == 2 && Polynomial().total_degree() == 0, "degrees");
  expect(Polynomial(rational(2, 4)).constant() == rational(1, 2), "2/4 = 1/2");
  expect((power(r, 5).with_square("r", x) - square(x) * r).is_zero(), "r^5 = x^2 r if r^2 = x");
  expect((cube(x).derivative("x") - Polynomial(3) * square(x)).is_zero(), "derivative of x^3");
  expect((cube(x).with("x", x + 1) - (cube(x) + Polynomial(3) * (square(x) + x) + 1)).is_zero(),
         "(x+1)^3");
  expect((resultant(square(x) - y, x - 3, "x") - (Polynomial(9) - y)).is_zero(), "a resultant");
  const auto powers = (square(x) * y + 5).coefficients_of("x");
  expect(powers.size() == 3 && (powers[2] - y).is_zero() && powers[1].is_zero() &&
             powers[0].constant() == 5,
         "coefficients of powers of x");
}

void check_roots() {
  const auto x = variable("x");
  const Polynomial f = cube(x) * square(x - 1) * (square(x) - 2) * (square(x) + 1);
  expect(count_roots(f, "x", -2, 2) == 4, "multiple roots count once, complex ones never");
  expect(count_roots(f, "x", 0, 1) == 0, "ends of the interval do not count");
  expect(count_roots(f, "x", -1, 1) == 1, "a multiple root inside, a root at an end");
  expect(count_roots(Polynomial(7), "x", -1, 1) == 0, "a constant has no root");
  expect(count_complex_roots(f, "x") == 6, "different complex roots");
  expect(count_common_roots(f, square(x - 1) * (x + 5), "x") == 1, "a common root");
}

template <class Assertion>
Checks::Outcome outcome_of(const Assertion& assertion) {
  Constants constants;
  Checks checks(constants);
  assertion(checks);
  return checks.outcome();
}

void check_certificates() {
  using Outcome = Checks::Outcome;
  const auto x = variable("x"), y = variable("y");
  expect(outcome_of([](Checks&) {}) == Outcome::undecided, "nothing asserted proves nothing");
  expect(outcome_of([&](Checks& c) { c.equal(x, y); }) == Outcome::refuted, "x is not y");
  expect(outcome_of([&](Checks& c) { c.positive_on_orthant(x + y); }) == Outcome::proved, "x + y");
  expect(outcome_of([&](Checks& c) { c.positive_on_orthant(0); }) == Outcome::refuted, "0 > 0");
  expect(outcome_of([&](Checks& c) { c.positive_on_orthant(square(x - y) + x); }) ==
             Outcome::undecided,
         "coefficients of both signs do not decide");
  expect(outcome_of([&](Checks& c) {
           c.positive_on(Polynomial(1) - x * x, {"x", -1, 1});
         }) == Outcome::proved,
         "1 - x^2 inside (-1, 1)");
  expect(outcome_of([&](Checks& c) {
           c.positive_on(square(x), {"x", -1, 1});
         }) == Outcome::refuted,
         "x^2 is zero inside");
  expect(outcome_of([&](Checks& c) {
           c.sum_of_squares(x * x - y * y, {{1, x}, {-1, y}});
         }) == Outcome::refuted,
         "a negative weight");
  expect(outcome_of([&](Checks& c) {
           c.sum_of_squares(x * x, {{1, x}, {1, y}});
         }) == Outcome::refuted,
         "the wrong sum");
}

void check_ids() {
  std::vector<std::string> ids = step_ids();
  std::sort(ids.begin(), ids.end());
  expect(std::adjacent_find(ids.begin(), ids.end()) == ids.end(), "no id is used twice");
  expect(run_steps({"mode-range"}).size() == 1 && run_steps({"none"}).empty(), "steps by id");
}

}  // namespace

int main() {
  check_polynomials();
  check_roots();
  check_certificates();
  check_ids();
  std::cout << failures << " failures\n";
  return failures == 0 && std::cout ? 0 : 1;
}
