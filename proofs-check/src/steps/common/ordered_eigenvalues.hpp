// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "algebra/matrix.hpp"
#include "certificates/constants.hpp"

namespace proofs {

/// Eigenvalues of a traceless T-bar: b2 and b1 = b2 + g. With b2 and g positive, b1 > b2 > 0 > b3.
struct OrderedEigenvalues {
  Polynomial b1 = variable("b2") + variable("g"), b2 = variable("b2"), b3 = -(b1 + b2);

  Vector3 all() const { return {b1, b2, b3}; }
  /// |T-bar|^2 / 2, which the paper makes 1/2.
  Polynomial half_norm() const { return square(b1) + b1 * b2 + square(b2); }
};

/// Delta for a diagonal T-bar of any norm at the squares m of the coordinates of a unit vector.
inline Polynomial boundary_function(const Vector3& b, const Vector3& m,
                                    const Polynomial& cosine_squared) {
  Polynomial norm, alpha, beta;
  for (std::size_t i = 0; i < 3; ++i) {
    norm += square(b[i]);
    alpha += b[i] * m[i];
    beta += square(b[i]) * m[i];
  }
  return rational(1, 2) * norm - beta + rational(1, 4) * cosine_squared * square(alpha);
}

/// On the boundary m_i is this over (b_i - b_j)(b_i - b_k).
inline Polynomial square_numerator(const Polynomial& b, const Polynomial& alpha,
                                   const Polynomial& cosine_squared) {
  return rational(1, 4) * cosine_squared * square(alpha) + b * alpha + square(b);
}

}  // namespace proofs
