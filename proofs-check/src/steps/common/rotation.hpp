// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "algebra/matrix.hpp"

namespace proofs {

inline Polynomial quaternion_norm() {
  return square(variable("q0")) + square(variable("q1")) + square(variable("q2")) +
         square(variable("q3"));
}

/// Each rotation of space times the squared norm of its quaternion: the columns are orthogonal and
/// of length quaternion_norm(), identically and without a relation.
inline Matrix3 rotation_times_norm() {
  const auto w = variable("q0"), x = variable("q1"), y = variable("q2"), z = variable("q3");
  const Polynomial two(2);
  return {{{w * w + x * x - y * y - z * z, two * (x * y - w * z), two * (x * z + w * y)},
           {two * (x * y + w * z), w * w - x * x + y * y - z * z, two * (y * z - w * x)},
           {two * (x * z - w * y), two * (y * z + w * x), w * w - x * x - y * y + z * z}}};
}

inline Vector3 column(const Matrix3& m, std::size_t j) { return {m[0][j], m[1][j], m[2][j]}; }

}  // namespace proofs
