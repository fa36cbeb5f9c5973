// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "certificates/constants.hpp"

namespace proofs {

/// Where a polynomial is to be positive, and what shows it.
struct Interval {
  std::string name;
  Rational low, high;
};

struct WeightedSquare {
  Polynomial weight, root;
};

/// What a step asserts. Each assertion is decided at once; a step passes if all of its assertions
/// are proved and it made at least one.
class Checks {
 public:
  explicit Checks(Constants& constants) : k(constants) {}
  Constants& k;

  enum class Outcome { proved, refuted, undecided };
  Outcome outcome() const;
  /// About the first assertion that was not proved.
  const std::string& reason() const { return reason_; }

  // --- Identities ---
  void vanishes(const Polynomial& f);
  void all_vanish(const std::vector<Polynomial>& all);
  void equal(const Polynomial& f, const Polynomial& g) { vanishes(f - g); }
  /// As polynomials: somewhere.
  void differ(const Polynomial& f, const Polynomial& g);
  void that(bool fact, const std::string& what);

  // --- Signs ---
  /// A number, greater than zero.
  void is_positive(const Polynomial& number);
  void is_negative(const Polynomial& number) { is_positive(-number); }
  /// Where all variables are positive, because all coefficients are.
  void positive_on_orthant(const Polynomial& f);
  void negative_on_orthant(const Polynomial& f) { positive_on_orthant(-f); }
  /// f is the sum of the squares and no weight is negative, so f is negative nowhere.
  void sum_of_squares(const Polynomial& f, const std::vector<WeightedSquare>& squares);
  /// In the open interval: f has no root there, by Sturm's theorem, and is positive in its middle.
  void positive_on(const Polynomial& f, const Interval& interval);

 private:
  void note(Outcome outcome, const std::string& reason);

  bool asserted_ = false;
  Outcome worst_ = Outcome::proved;
  std::string reason_;
};

}  // namespace proofs
