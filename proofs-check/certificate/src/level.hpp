// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What signs of coefficients prove about the level mu + 0 on a simplex.
#pragma once

#include <atomic>
#include <cstdint>

#include "ball.hpp"
#include "forms.hpp"

namespace certificate {

/// Whoever has exact tensors, and makes them when asked.
class ExactTensors {
 public:
  virtual ~ExactTensors() = default;
  virtual Tensor<mpz_class> exact(std::uint32_t id) const = 0;
};

/// A tensor, up to a positive factor: exactly, and exact / 2^shift enclosed.
struct Corner {
  const Tensor<Ball>* ball = nullptr;
  long shift = 0;
  const ExactTensors* source = nullptr;
  std::uint32_t id = 0;
  bool above = false;

  Tensor<mpz_class> exact() const { return source->exact(id); }
};

enum class Proof : std::uint8_t {
  open,      ///< none found
  empty,     ///< the simplex does not hold the level
  monotone,  ///< the mode increases strictly along one direction, and P > 0
};

/// A proof, and the direction along which it holds if it is `monotone`: in weights of
/// exact / 2^shift of the corners.
template <std::size_t V>
struct Proved {
  Proof proof = Proof::open;
  std::array<int, V> direction{};
};

/// The level of the mode numerator/denominator, and how often each arithmetic decided.
class Level {
 public:
  /// @pre |numerator| < denominator
  Level(mpz_class numerator, mpz_class denominator);

  /// Is the mode of this tensor greater than mu? (mu itself is below.)
  bool above(const Corner& corner) const;
  bool above(const Tensor<Ball>& ball, const Tensor<mpz_class>& exact) const;
  /// Is the mode exactly mu?
  bool on_level(const Corner& corner) const;

  /// @pre V is 2, 3 or 4
  template <std::size_t V>
  Proved<V> prove(const std::array<Corner, V>& corners) const;

  /// Is all of the simplex on the side of its corners (which is that of the first)?
  template <std::size_t V>
  bool is_one_sided(const std::array<Corner, V>& corners) const;

  std::uint64_t decided_by_balls() const { return by_balls_; }
  std::uint64_t decided_exactly() const { return by_integers_; }

 private:
  /// F = q Q^2 + p P^3.
  template <class N>
  struct Factors {
    N q, p;
  };
  template <class N, std::size_t V>
  Polynomial<N, V, 6> degree_six(const Forms<N, V>& f) const;
  template <class N, std::size_t V>
  Answer lies(bool above, const Forms<N, V>& f) const;
  template <std::size_t V>
  bool lies_by_norm(const std::array<Corner, V>& corners, const Forms<Ball, V>& f) const;
  template <std::size_t V>
  class Simplex;

  int sign_;  ///< of mu
  Factors<mpz_class> exact_;
  Factors<Ball> balls_;  ///< both divided by one positive number
  Factors<Ball> root_;  ///< of q Q + p P sqrt(P/54), of the sign of the mode less mu; divided alike
  mutable std::atomic<std::uint64_t> by_balls_{0}, by_integers_{0};
};

}  // namespace certificate
