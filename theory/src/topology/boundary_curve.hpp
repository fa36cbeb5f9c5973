// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensors.hpp"

namespace tensortopo::theory {

/// Proves that one of the two loops of the complex domain's boundary has all of its tensors inside
/// a tetrahedron of the field, so that it meets no face; false if the proof fails.
///
/// For mu < mu0 the loops lie, in the eigenvectors of the characteristic tensor, among the vectors
/// with x z > 0 and among those with x z < 0; that this is so, is proved too. The vectors are
/// covered by boxes, which are halved until the boundary function has a strict sign or the weights
/// of the boundary's tensor show it inside. In intervals, so that either is certain.
///
/// @param values    characteristic eigenvalues, descending
/// @param s         the parameter of the mode
/// @param vertices  in the eigenvectors; a basis of the span orthogonal to the values
/// @param side      1 or -1: the sign of x z
bool loop_is_inside(const std::array<Rational, 3>& values, const Rational& s,
                    const std::array<Tensor, 4>& vertices, int side);

}  // namespace tensortopo::theory
