// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/surface/boundary/level_boundary.hpp"

namespace tensortopo {

/// The crossings of all edges.
template <class Scalar>
MeshCrossings<Scalar> find_crossings(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                                     const TetComplex& cells);

}  // namespace tensortopo
