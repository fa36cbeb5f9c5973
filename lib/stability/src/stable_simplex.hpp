// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "box_simplex.hpp"

namespace tensortopo::stability {

/// True only if the mode of every tensor in a ball is on one side of mu, and none is isotropic.
///
/// The mode is cos(3 phi), phi in [0, pi/3] the Lode angle, which changes by at most arcsin(e /
/// |D|) in the ball, and by as much somewhere. So this is decided up to rounding.
///
/// @param tensor  of norm from 1 to `kLargestNorm`
/// @param mu      rounded
bool side_is_stable(const Traceless& tensor, double radius, double mu);

/// True only if no member of a box has, in a simplex of two to four vertices, a zero, or a point of
/// mode mu at which all derivatives of the mode in the simplex vanish.
///
/// The simplex is bisected until each part is regular (see `is_regular`).
///
/// @param parts  most parts to look at
template <std::size_t Vertices>
bool has_no_critical_point(const BoxSimplex<Vertices>& simplex, double mu, int parts);

}  // namespace tensortopo::stability
