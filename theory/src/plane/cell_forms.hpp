// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plane/plane.hpp"

namespace tensortopo::theory {

/// |mode| = mu in a plane: where the form 6 q (tr T^3)^2 - p |T|^6 is zero, mu^2 = p / q.
struct Level {
  Integer numerator, denominator;

  explicit Level(const Rational& mode_squared);
  /// Negative where |mode| < mu.
  Sign at(const IntegerTensor& t) const;
};

/// What is certain about the curves of a level in a triangle, by the signs of coefficients.
enum class CellKind : unsigned char {
  empty,  ///< none of them
  /// The mode increases along some direction, the same everywhere, and no side is met twice: one
  /// arc between two sides, or nothing.
  simple,
  unclear,
};

/// For the triangle between tensors at its corners, given up to positive factors, in a plane in
/// which tensors change by combinations of the two `directions`.
CellKind kind_of_cell(const std::array<IntegerTensor, 3>& corners,
                      const std::array<IntegerTensor, 2>& directions, const Level& level);

}  // namespace tensortopo::theory
