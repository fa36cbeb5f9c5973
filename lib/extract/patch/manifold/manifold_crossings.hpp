// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "extract/patch/manifold/tet_manifold.hpp"
#include "extract/patch/patch.hpp"

namespace tensortopo {

/// Nothing where the parameterization does not apply: fewer than four independent vertex tensors.
template <class Scalar>
std::unique_ptr<TetManifold> tet_manifold(const TetWithCurves<Scalar>& tet,
                                          const Level<Scalar>& level);

/// Whether a boundary loop has a stretch along a singular line, or closer to one than a chart can
/// show: in a plane of symmetry the whole line is the level on a face. There is nothing to mesh on
/// then.
template <class Scalar>
bool runs_along_singularity(const TetManifold& manifold, const CellTopology<Scalar>& proved,
                            const FaceArcVertices& vertices);

/// Where the mode curves on the faces cross the boundary of the complex domain: the places that
/// become samples of the shared curves. Found by the sign of sigma along the curves, with the
/// medium eigenvector continued (on a curve the boundary function itself has a double zero).
template <class Scalar>
std::vector<SampleRequest<Scalar>> boundary_crossings(const TetManifold& manifold,
                                                      const TetWithCurves<Scalar>& tet,
                                                      const CellTopology<Scalar>& proved,
                                                      const FaceArcVertices& vertices,
                                                      const Level<Scalar>& level);

/// A request for the middle of each step from one sample to the next along the tetrahedron's
/// loops, and the vertices with those samples added (whose ids are -1 as yet).
template <class Scalar>
std::vector<SampleRequest<Scalar>> denser_loops(const TetWithCurves<Scalar>& tet,
                                                const CellTopology<Scalar>& proved,
                                                FaceArcVertices& vertices,
                                                const Level<Scalar>& level);

}  // namespace tensortopo
