// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "box_simplex.hpp"

namespace tensortopo::stability {

/// True only if at every point of a part, and for every member T of the box, T is not zero, and
/// the mode is not mu or has a derivative along d that is not zero.
///
/// With nu = mu / sqrt(6) the mode is mu where trace(T^3) = nu |T|^3. With the deviator A =
/// sum of d_i T_i the derivative of the mode along d has there the sign of
///   F = trace(T T A) - nu |T| <T, A>,
/// and F has that of the mode less mu where A = T. So d need not keep the sum of coordinates.
/// F is affine in s = |T|, which for members lies between s = <u, T>, u a unit tensor, and the
/// convex function |T|. Both are replaced by what is linear along the part, so that F is
/// a quadratic form there, of which the coefficients are asked to be positive. A coefficient
/// is a polynomial in the deviations E_i of the vertex tensors:
/// - its linear part is at least minus the sum of e_i |gradient by E_i|;
/// - the rest is bounded by norms: |trace(S T U)| <= |S| |T| |U| / sqrt(6), and
///   <T/|T|, E> <= |T + E| - |T| <= <T/|T|, E> + e^2 / (2 |T|).
///
/// @param d  any; that it proves something is all that is asked of it
template <std::size_t Vertices, std::size_t Corners>
bool is_regular(const BoxSimplex<Vertices>& simplex, const Part<Vertices, Corners>& part,
                const std::array<double, Vertices>& d, double nu);

}  // namespace tensortopo::stability
