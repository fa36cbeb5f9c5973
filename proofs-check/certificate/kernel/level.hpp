// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What signs of coefficients prove about the level, of a mode or of another invariant, on a
// simplex.
#pragma once

#include <atomic>
#include <cstdint>
#include <variant>

#include "invariant_rule.hpp"
#include "mode_rule.hpp"

namespace certificate {

/// A source of exact tensors, which makes them when asked.
class ExactTensors {
 public:
  virtual ~ExactTensors() = default;
  virtual Tensor<mpz_class> exact(std::uint32_t id) const = 0;
};

/// A tensor: exactly, and exact / 2^shift enclosed.
struct Corner {
  const Tensor<Ball>* ball = nullptr;
  long shift = 0;
  const ExactTensors* source = nullptr;
  std::uint32_t id = 0;
  bool above = false;
  double reach = HUGE_VAL;  ///< if it is known

  Tensor<mpz_class> exact() const { return source->exact(id); }
};

enum class Proof : std::uint8_t {
  open,      ///< none found
  empty,     ///< the simplex does not hold the level
  /// along one direction the level is only crossed upwards: a function with the sign of the mode (or
  /// invariant) less the level increases strictly
  monotone,
};

/// A proof, and the direction along which it holds if it is `monotone`: in weights of
/// exact / 2^shift of the corners.
template <std::size_t V>
struct Proved {
  Proof proof = Proof::open;
  std::array<int, V> direction{};
  bool by_integers = false;  ///< doubles left something open, whether integers helped or not
};

/// The level, and how often each arithmetic decided.
///
/// What it is a level of, is asked of a rule only: on which side of it a form says that all of a
/// simplex lies, and forms that are positive only if the level is crossed upwards along a direction.
class Level {
 public:
  /// Of a mode. @pre |numerator| < denominator
  Level(const mpz_class& numerator, const mpz_class& denominator)
      : rule_(ModeRule(numerator, denominator)) {}
  /// Of another invariant. @pre 0 < value, and < 1 for an anisotropy
  Level(Invariant invariant, const mpq_class& value) : rule_(InvariantRule(invariant, value)) {}

  /// What tensors it is about.
  Multiples multiples() const;
  /// Is the tensor above? (On the level is below.)
  bool above(const Corner& corner) const;
  /// Is it exactly on the level? @pre it is not zero
  bool on_level(const Corner& corner) const;

  /// A number h: tensors T with tr(M T) > h |T| for the corner M are on its side.
  double reach(const Corner& corner) const;

  /// @pre V is 1 to 4
  /// @param asks_for_side  not for directions, and whether corners are on one side is not asked
  template <std::size_t V>
  Proved<V> prove(const std::array<Corner, V>& corners, bool asks_for_side = false) const;

  /// Is all of the simplex on the side of its corners (which is that of the first)?
  template <std::size_t V>
  bool is_one_sided(const std::array<Corner, V>& corners) const {
    return prove(corners, true).proof == Proof::empty;
  }

  /// Calls f with the rule of what it is a level of.
  auto visit(const auto& f) const { return std::visit(f, rule_); }

  /// Is the tensor above, as far as doubles tell? Not for proofs.
  bool seems_above(const Tensor<Ball>& m) const {
    return Answer::yes ==
           visit([&](auto& rule) { return rule.lies(true, rule.template forms<Ball, 1>({&m})); });
  }

  /// 1 - mode^2 of the level of a mode, else 1. Not for proofs.
  double tube() const { return visit([](auto& rule) { return rule.tube(); }); }

  std::uint64_t decided_by_balls() const { return by_balls_; }
  std::uint64_t decided_exactly() const { return by_integers_; }

 private:
  template <class Rule, std::size_t V>
  class Simplex;
  bool ask(const Corner& corner, const auto& question) const;

  std::variant<ModeRule, InvariantRule> rule_;
  mutable std::atomic<std::uint64_t> by_balls_{0}, by_integers_{0};
};

}  // namespace certificate
