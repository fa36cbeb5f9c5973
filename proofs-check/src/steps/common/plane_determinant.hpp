// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "algebra/matrix.hpp"

namespace proofs {

/// det(u T1 + v T2 + w T3) and its gradient (f, g, h).
struct PlaneDeterminant {
  Polynomial u = variable("u"), v = variable("v"), w = variable("w");
  Polynomial value, f, g, h;

  explicit PlaneDeterminant(const Polynomial& determinant)
      : value(determinant),
        f(value.derivative("u")),
        g(value.derivative("v")),
        h(value.derivative("w")) {}
  /// Of a basis.
  explicit PlaneDeterminant(const std::array<Matrix3, 3>& basis)
      : PlaneDeterminant(determinant(combination(basis))) {}
  /// Any cubic form: the determinant on a plane is one.
  static PlaneDeterminant any();

  static Matrix3 combination(const std::array<Matrix3, 3>& basis) {
    const Vector3 weights{variable("u"), variable("v"), variable("w")};
    Matrix3 sum;
    for (std::size_t n = 0; n < 3; ++n)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) sum[i][j] += weights[n] * basis[n][i][j];
    return sum;
  }
};

inline PlaneDeterminant PlaneDeterminant::any() {
  const std::array<std::string, 3> names{"u", "v", "w"};
  Polynomial form;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      for (std::size_t k = j; k < 3; ++k)
        form += variable("c" + names[i] + names[j] + names[k]) * variable(names[i]) *
                variable(names[j]) * variable(names[k]);
  return PlaneDeterminant(form);
}

/// E12, E13, E23, which have ones in two places: det = 2 u v w.
inline std::array<Matrix3, 3> plane_of_shears() {
  return {symmetric(0, 0, 0, 1, 0, 0), symmetric(0, 0, 0, 0, 0, 1), symmetric(0, 0, 0, 0, 1, 0)};
}

/// The first is diag(2, -1, -1), of mode 1; orthogonal, of squared norm 6.
inline std::array<Matrix3, 3> plane_with_degenerate_first() {
  return {diagonal({2, -1, -1}), symmetric(0, 0, 0, 1, 1, 1), symmetric(0, 1, -1, 1, 0, -1)};
}

/// A plane of no special position; orthogonal, of squared norm 12.
inline std::array<Matrix3, 3> general_plane() {
  return {symmetric(-1, -1, 2, 1, -1, 1), symmetric(0, 0, 0, -1, -2, -1),
          symmetric(-2, 2, 0, 1, 0, -1)};
}

}  // namespace proofs
