// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "algebra/matrix.hpp"
#include "certificates/constants.hpp"

namespace proofs {

/// A = R(theta/2 + pi/4) T' R(theta/2 - pi/4) for a symmetric T' = [[x, y], [y, z]], in
/// h = cos(theta/2), g = sin(theta/2), r = cos(pi/4).
struct AsymmetricTensor {
  Polynomial h = variable("h"), g = variable("g"), r = variable("r");
  Polynomial half, plus_cosine, plus_sine, minus_cosine, minus_sine;

  explicit AsymmetricTensor(const Polynomial& squared_cosine_of_45 = rational(1, 2))
      : half(squared_cosine_of_45) {
    plus_cosine = r * (h - g);
    plus_sine = r * (g + h);
    minus_cosine = r * (h + g);
    minus_sine = r * (g - h);
  }
  /// sin(theta)
  Polynomial sine(Constants& k) const { return k(2) * g * h; }
  static Matrix2 rotation(const Polynomial& cosine, const Polynomial& sine) {
    return {{{cosine, -sine}, {sine, cosine}}};
  }
  Matrix2 of(const Matrix2& restricted) const {
    return rotation(plus_cosine, plus_sine) * restricted * rotation(minus_cosine, minus_sine);
  }
  /// The same with both rotations turned the other way: seen in a basis of the other handedness.
  Matrix2 opposite_of(const Matrix2& restricted) const {
    return rotation(plus_cosine, -plus_sine) * restricted * rotation(minus_cosine, -minus_sine);
  }
  Polynomial reduced(const Polynomial& f) const {
    return f.with_square("r", half).with_square("g", Polynomial(1) - square(h));
  }
};

/// The symmetric tensor [[x, y], [y, z]].
inline Matrix2 restricted() {
  const auto x = variable("x"), y = variable("y"), z = variable("z");
  return {{{x, y}, {y, z}}};
}

}  // namespace proofs
