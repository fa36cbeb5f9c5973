// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "plane/plane.hpp"

namespace tensortopo::theory {

/// The equations of critical points, without the orthogonal complement.
///
/// With T = s B_1 + t B_2 + B_3 let f be the vector of <T^2, B_i>, which is the gradient of the
/// determinant, and p that of <T, B_i>. T is critical if f x p = 0. Two of the three components,
/// cubics in s and t, make a resultant in s. Where p_3 = f_3 = 0 these two vanish and the third
/// need not: such solutions are spurious.
struct Elimination {
  bool proper = false;  ///< B_2, where all lines of constant s meet, is not a solution
  Polynomial all;       ///< the resultant
  Polynomial spurious;  ///< the resultant of p_3 and f_3
  /// Over the zeros of `all`, if this is square-free and of the degree nine: coordinates in the
  /// basis B of the one solution there.
  Vector3<Polynomial> solution;
};

/// For a basis of the plane's tensors.
Elimination eliminate(const std::array<IntegerTensor, 3>& basis);

/// Like this, the common zeros of the quadratic forms of two matrices: e = (s, t, 1).
struct Conics {
  bool proper = false;
  Polynomial all;                ///< the resultant
  Vector3<Polynomial> solution;  ///< over its zeros, if it is square-free and of degree four
};

Conics eliminate(const IntegerTensor& first, const IntegerTensor& second);

}  // namespace tensortopo::theory
