// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "extract/patch/manifold/manifold_crossings.hpp"

namespace tensortopo {

/// Triangles for all sheets of a tetrahedron, by triangulating the region on the manifold that
/// its face curves and parts of the complex domain's boundary bound, with samples of a grid
/// inside.
///
/// @param requests the samples asked for, which must be on the arcs by now; those on the boundary
///                 of the complex domain are where the curves cross it
/// @return false if the samples do not suffice: curves cross in the chart, a crossing is missing,
///         or the result's topology is not the proved
template <class Scalar>
bool mesh_on_manifold(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                      const CellTopology<Scalar>& proved,
                      std::span<const SampleRequest<Scalar>> requests,
                      const FaceArcVertices& vertices, const Level<Scalar>& level,
                      const Sampling& sampling, int defect_rounds, Patch<Scalar>& out);

}  // namespace tensortopo
