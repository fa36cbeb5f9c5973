// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "tensortopo/quadric/invariant_level.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// With P(T) = 3 |D|^2 the level of each invariant is q = 0 for one quadratic form,
/// q(T) = P(T) + tau (tr T)^2 - gamma, and larger values have q > 0. |T| = v and |D| = v have
/// gamma = 3 v^2, and tau = 1 and 0; |D| = v |T| has gamma = 0, tau = -v^2 / (1 - v^2).
struct QuadraticLevel {
  Rational tau;  ///< exact
  Rational gamma;  ///< exact
  double value = 0;  ///< nearest to the level's value; gamma is three times its square, or 0

  /// Of any level that `InvariantLevel` takes.
  explicit QuadraticLevel(const InvariantLevel& level);
};

/// q in a linear field on a tetrahedron, as a quadratic form in barycentric coordinates.
class QuadricForm {
 public:
  /// Requires finite tensors, which must outlive this, as must the level.
  QuadricForm(const QuadraticLevel& level,
            const std::array<const SymmetricTensor<double>*, 4>& tensors);

  /// The matrix of the form, row by row; of tensors and value scaled by a power of two.
  const std::array<double, 4>& operator[](std::size_t i) const { return form_[i]; }
  /// An entry of it unscaled, exactly.
  Rational exact(std::size_t i, std::size_t j) const;

  /// |entry| <= size(i) size(j).
  double size(std::size_t i) const { return size_[i]; }
  /// Error of the form at two places with integer coordinates below 2^16, over the product of their
  /// sizes, which are sums like the places; provided that these are above `kSmallestSize`.
  static constexpr double kError = 64 * std::numeric_limits<double>::epsilon();
  /// Below this, products of sizes may underflow.
  static constexpr double kSmallestSize = 0x1p-430;

 private:
  const QuadraticLevel& level_;
  std::array<const SymmetricTensor<double>*, 4> tensors_;
  std::array<std::array<double, 4>, 4> form_;
  std::array<double, 4> size_;
};

}  // namespace tensortopo
