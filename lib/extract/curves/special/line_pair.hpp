// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "extract/curves/points/exact_direction.hpp"

namespace tensortopo {

/// A singular quadratic form with trace zero: the product of two real linear forms, whose lines in
/// the projective plane meet in the form's kernel, at right angles.
class LinePair {
 public:
  explicit LinePair(const SymmetricTensor<Rational>& form);

  const Vector3<Rational>& kernel() const { return kernel_; }
  /// The line k holds the kernel and this direction.
  ExactDirection direction(std::size_t k) const;
  /// The vector across all directions of line k.
  ExactDirection normal(std::size_t k) const;

  /// The directions of either line at which another form vanishes, each once. Requires that it does
  /// not vanish on a whole line.
  std::vector<ExactDirection> zeros_of(const SymmetricTensor<Rational>& other) const;

 private:
  Vector3<Rational> kernel_, u_, v_;  ///< independent
  /// The direction of line k is `along_[0] u + (along_[1] -+ sqrt(square_)) v`, or the same with u
  /// and v exchanged, or they are u and v.
  std::array<Rational, 2> along_;
  Rational square_;
  bool axes_ = false;
};

}  // namespace tensortopo
