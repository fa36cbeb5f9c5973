// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "box_simplex.hpp"

namespace tensortopo::stability {

/// A direction that may serve `is_regular` on a part; a guess.
///
/// To first order in the deviations E_i, the form F of `is_regular` at a point with coordinates x
/// is <N, A> + sum of <E_i, d_i N + x_i W(d)>, N = T T - nu |T| T without its trace and W the
/// derivative of N along the field's. There is a d that makes it positive for all members if and
/// only if no member has F = 0 for all d, which is: mode mu, and no derivative in the simplex. Such
/// a d minimises the sum of e_i |d_i N + x_i W(d)| where <N, A> = 1. Here this is done by weighted
/// least squares, with the squares of what F changes by along the part added.
///
/// @param steps  of reweighting; 0: one solution of least squares
template <std::size_t Vertices, std::size_t Corners>
std::array<double, Vertices> guess_direction(const BoxSimplex<Vertices>& simplex,
                                             const Part<Vertices, Corners>& part, double nu,
                                             int steps);

}  // namespace tensortopo::stability
