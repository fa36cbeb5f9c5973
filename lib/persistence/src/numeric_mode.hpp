// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/field/mode_along_segments.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/deviator.hpp"

/// \file
/// The mode in floating point: it guides searches, and proves nothing.

namespace tensortopo::persistence {

using Deviators = std::array<Deviator<double>, 4>;

/// Of a tetrahedron, all times one power of two that makes the largest component about 1.
Deviators deviators_of(const TetMesh& mesh, TetMesh::Index tet);

Deviator<double> combine(const Deviators& corners, const TetWeights& weights);

/// The Lode angle, 0 at mode 1; larger than all angles if there is none.
double angle_of(const Deviator<double>& t);

/// Derivative of the mode at t towards u, times a positive number that does not depend on u.
double derivative(const Deviator<double>& t, const Deviator<double>& u);

/// A direction within the simplex of the corners used, its weights of sum 0: Newton's, but uphill
/// along all axes of curvature. It leads along a crest, where the gradient leads across.
TetWeights newton_direction(const Deviators& corners, const TetWeights& weights,
                            const std::array<bool, 4>& is_used);

/// A direction within the span of the corners with a weight in which the mode rises most, by its
/// second derivative; its weights have sum 0. All zero if there is none.
TetWeights direction_of_rise(const Deviators& corners, const TetWeights& weights);

}  // namespace tensortopo::persistence
