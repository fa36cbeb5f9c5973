// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "extract/subdivision/refinement.hpp"

namespace tensortopo::detail {

/// How much the mode bends along the edges of a tetrahedron, in the order of `kTetEdges`: their
/// squared lengths in the metric |H|, where H is the matrix of the mode's second derivatives in the
/// middle, in coordinates in which the tetrahedron is regular. An edge along a line of saddles is
/// short, however long it is. All zeros where the deviator vanishes in the middle.
///
/// It says which edge is better cut, and nothing about the level.
template <class Scalar>
std::array<double, 6> hessian_lengths(
    const std::array<const RefinementVertex<Scalar, 4>*, 4>& corners);

}  // namespace tensortopo::detail
