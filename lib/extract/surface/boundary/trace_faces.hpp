// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/surface/boundary/level_boundary.hpp"

namespace tensortopo {

/// The curves of all faces between the crossings.
template <class Scalar>
LevelBoundary<Scalar> trace_faces(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                                  const TetComplex& cells, MeshCrossings<Scalar> crossings);

/// A tetrahedron and the curves on its faces; refers to these.
template <class Scalar>
TetWithCurves<Scalar> tet_with_curves(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                                      const TetComplex& cells,
                                      const LevelBoundary<Scalar>& boundary, std::size_t t);

}  // namespace tensortopo
