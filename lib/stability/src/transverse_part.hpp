// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "box_simplex.hpp"

namespace tensortopo::stability {

/// True only if at every point of a part, and for every member T of the box, T is not zero, and
/// is not linear degenerate or crosses the linear degenerate tensors transversally.
///
/// Linear degenerate deviators are s (n n^T - I/3), s > 0, n a unit vector. Two traceless tensors
/// B_1, B_2 in the plane across n span what is orthogonal to them there. The crossing is
/// transverse if the columns M_i = (<B_1, T_i>, <B_2, T_i>), T_i the member's vertex tensors, have
/// rank 2; along an edge they never do, because a combination of them vanishes.
///
/// - *Not degenerate*: the mode's Lode angle is the angle to the nearest linear degenerate tensor.
///   All members lie in a cone around the part's centre; its half angle is less than the centre's
///   Lode angle. Or, with the cone of the next case: the parts of members that are normal to the
///   degenerate tensors of axis n are larger than what they can change by on the way to other axes.
/// - *Transverse*: all members lie in a cone of half angle a around a linear degenerate tensor of
///   axis n. The axes of the degenerate ones are then at most t from n, sin t = 2 sin(a/2) /
///   sqrt(3), for the angle between two such tensors has the cosine (3 cos^2 t - 1) / 2. If the
///   plane is turned along by t, then M_i changes by at most sqrt(2) t |component of T_i n across
///   n|
///   + t^2 |T_i|, and by at most t |T_i|; a deviation E_i changes it by at most |E_i|. The columns
///   have rank 2 if no vector of the plane is orthogonal to all of them after any such change.
template <std::size_t Vertices, std::size_t Corners>
bool is_transverse(const BoxSimplex<Vertices>& simplex, const Part<Vertices, Corners>& part);

}  // namespace tensortopo::stability
