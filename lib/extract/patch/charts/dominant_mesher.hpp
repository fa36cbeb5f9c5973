// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/patch/charts/manifold_mesher.hpp"

namespace tensortopo {

/// Triangles for all sheets of a tetrahedron, as `mesh_on_manifold`, in a `DominantChart`: for
/// sheets that the medium eigenvector alone does not spread out, as long thin tubes cut along by a
/// face, or what is beside a plane of symmetry.
///
/// @return false if the chart does not show them: boundary loops cross in it, a step along a
/// boundary loop is
///         ambiguous, or the result's topology is not the proved
template <class Scalar>
bool mesh_by_dominant(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                      const CellTopology<Scalar>& proved, const FaceArcVertices& vertices,
                      const Level<Scalar>& level, const Sampling& sampling, int defect_rounds,
                      Patch<Scalar>& out);

}  // namespace tensortopo
