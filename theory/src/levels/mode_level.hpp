// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "integer.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/theory/bounded.hpp"

namespace tensortopo::theory {

using BoundedDeviator = Deviator<Bounded<double>>;

/// A level of the mode: a rational square, and a sign.
///
/// Everything asked of it is a sign of polynomials in the tensor, so that the mode itself need not
/// be rational.
struct ModeLevel {
  Rational mu_squared;
  int sign = 1;  ///< 1 or -1; of no effect for mode 0

  /// The tensors of determinant 0.
  static ModeLevel neutral() { return {Rational(0), 1}; }
  /// Of the tensors with eigenvalues (3 + s, -2 s, s - 3), 0 <= s <= 1, times `sign`.
  static ModeLevel of_parameter(const Rational& s, int sign = 1);

  bool is_neutral() const { return mu_squared == 0; }
};

/// The primitive vector of integers on the ray of a tensor. (The mode does not see its length.)
Deviator<Integer> primitive(const Deviator<Rational>& tensor);
Deviator<Integer> primitive(const Deviator<Integer>& tensor);

/// The power of two, as an exponent, at or below the largest entry.
long binary_size(const Deviator<Integer>& tensor);

/// The tensor divided by 2^shift.
BoundedDeviator bounded(const Deviator<Integer>& tensor, long shift);

/// Whether the mode of the tensor is above the level; decided exactly.
bool is_above(const Deviator<Integer>& tensor, const ModeLevel& level);

/// The sign of the mode less the level, as far as the bounds tell.
Verdict side(const BoundedDeviator& tensor, const ModeLevel& level, const Bounded<double>& square);

}  // namespace tensortopo::theory
