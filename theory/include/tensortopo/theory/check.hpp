// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <type_traits>
#include <utility>

#include "tensortopo/theory/facts.hpp"
#include "tensortopo/theory/trial.hpp"

namespace tensortopo::theory {

/// Tries a statement on one field, in any kind of number that suffices for it.
///
/// Made from a function of a trial and of the facts to fill in. One that takes `auto& facts` is
/// there for every arithmetic; one that takes `Facts<Rational>& facts` needs exact signs.
class Check {
 public:
  Check() = default;

  template <class Function>
  requires(!std::is_same_v<std::decay_t<Function>, Check>) Check(Function function) {
    rational_ = function;
    if constexpr (std::is_invocable_v<Function&, const Trial&, Facts<Interval>&>) {
      interval_ = function;
      real100_ = function;
      real53_ = function;
    }
  }

  /// Whether the statement can be tried with these numbers.
  bool suffices(Arithmetic arithmetic) const {
    return arithmetic == Arithmetic::rational ? bool(rational_) : bool(interval_);
  }
  /// Requires `suffices(arithmetic)`.
  Outcome operator()(const Trial& trial, Arithmetic arithmetic = Arithmetic::rational,
                     Mutation mutation = {}) const;
  /// How many numbers the claim has, counted on a trial that satisfies its hypotheses.
  std::size_t constants(const Trial& trial) const;

 private:
  template <class Scalar>
  using Over = std::function<void(const Trial&, Facts<Scalar>&)>;

  Over<Rational> rational_;
  Over<Interval> interval_;
  Over<Bounded100> real100_;
  Over<Bounded53> real53_;
};

}  // namespace tensortopo::theory
