// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensors.hpp"

namespace tensortopo::theory {

/// Tensors d_i of which <d_i, t> is the weight of vertex i in t, up to a common positive factor.
/// Requires independent tensors.
std::array<Tensor, 4> dual_basis(const std::array<Tensor, 4>& vertices);

/// Proves that one of the two loops of the complex domain's boundary has all of its tensors inside
/// a tetrahedron of the field, so that it meets no face; 0 if the proof fails, or from the critical
/// mode on, where there is one loop only.
///
/// For mu < mu0 the loops lie, in the eigenvectors of the characteristic tensor, among the vectors
/// with x z > 0 and among those with x z < 0, and alpha = v.T v runs over an interval at whose ends
/// y = 0 (the statement boundary-parameter). That interval is halved until the weights of the
/// boundary's tensors have strict signs. In intervals, so that either is certain.
///
/// @param values    characteristic eigenvalues, descending
/// @param s         the parameter of the mode
/// @param vertices  in the eigenvectors; a basis of the span orthogonal to the values
/// @param side      1 or -1: the sign of x z
/// @return          1 if the loop is part of the surface of mode mu there, -1 if of that of -mu
int mode_of_loop_inside(const std::array<Rational, 3>& values, const Rational& s,
                        const std::array<Tensor, 4>& vertices, int side);

/// The same without the sign.
inline bool loop_is_inside(const std::array<Rational, 3>& values, const Rational& s,
                           const std::array<Tensor, 4>& vertices, int side) {
  return mode_of_loop_inside(values, s, vertices, side) != 0;
}

/// Proves in the same way that the loop has no tensor in the tetrahedron; false if that fails.
bool loop_is_outside(const std::array<Rational, 3>& values, const Rational& s,
                     const std::array<Tensor, 4>& vertices, int side);

}  // namespace tensortopo::theory
