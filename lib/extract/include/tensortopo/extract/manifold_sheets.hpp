// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tensortopo/extract/tet_sheets.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/manifold/field_lift.hpp"
#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"

namespace tensortopo {

/// The medium eigenvector manifold of one tetrahedron's linear field, for drawing its sheets as
/// the paper does (section on extraction inside a tetrahedron). It guides samples and
/// connectivity only, so double serves; what it draws is checked against the proved topology.
///
/// A neutral surface is drawn on the manifold of a mode next to 0. Its complex domain is an oval
/// around each singularity, too small to hold a sample, and the oval's boundary stands for the
/// straight line of the surface that has the singularity as medium eigenvector everywhere: the
/// point is blown up to the line. Vertices are put on the level afterwards. In the same way a
/// characteristic tensor of mode 0, whose ovals are points for every mode, is taken for one next to
/// it.
struct TetManifold {
  CharacteristicTensor<double> characteristic;
  MediumEigenvectorManifold<double> manifold;
  FieldLift<double> lift;  ///< to weights in the scaled vertex tensors
  int sign;                ///< of the mode
  bool small_ovals;        ///< the medium eigenvector does not tell places along an oval

  /// Where on the boundary of the complex domain the medium eigenvector, or its opposite, of a
  /// tensor on it is. Where ovals are small, as for a neutral surface, the eigenvector is nearly a
  /// singularity, and it is the dominant eigenvector that tells the place.
  BoundaryPosition<double> boundary_position(const Vector3<double>& medium,
                                             const Vector3<double>& dominant) const;
};

/// Nothing where the parameterization does not apply: fewer than four independent vertex tensors.
template <class Scalar>
std::unique_ptr<TetManifold> tet_manifold(const TetWithCurves<Scalar>& tet,
                                          const Level<Scalar>& level);

/// Whether a rim has a stretch along a singular line, or closer to one than a chart can show: in a
/// plane of symmetry the whole line is the level on a face. There is nothing to draw on then.
template <class Scalar>
bool runs_along_singularity(const TetManifold& manifold, const TetPlan<Scalar>& plan,
                            const FaceArcVertices& vertices);

/// Where the mode curves on the faces cross the boundary of the complex domain: the places that
/// become samples of the shared curves. Found by the sign of sigma along the curves, with the
/// medium eigenvector continued (on a curve the boundary function itself has a double zero).
template <class Scalar>
std::vector<RimRequest<Scalar>> boundary_crossings(const TetManifold& manifold,
                                                   const TetWithCurves<Scalar>& tet,
                                                   const TetPlan<Scalar>& plan,
                                                   const FaceArcVertices& vertices,
                                                   const Level<Scalar>& level);

/// A request for the middle of each step from one sample to the next along the tetrahedron's
/// loops, and the vertices with those samples added (whose ids are -1 as yet).
template <class Scalar>
std::vector<RimRequest<Scalar>> denser_rims(const TetWithCurves<Scalar>& tet,
                                            const TetPlan<Scalar>& plan, FaceArcVertices& vertices,
                                            const Level<Scalar>& level);

/// Further samples of the curves so that the chords between samples do not cross in the chart, as
/// those of two curves close to each other may: where they do, steps are halved.
///
/// @param crossings the `boundary_crossings`, which are samples as well
template <class Scalar>
std::vector<RimRequest<Scalar>> separating_samples(const TetManifold& manifold,
                                                   const TetWithCurves<Scalar>& tet,
                                                   const TetPlan<Scalar>& plan,
                                                   const FaceArcVertices& vertices,
                                                   std::span<const RimRequest<Scalar>> crossings,
                                                   const Level<Scalar>& level);

/// Triangles for all sheets of a tetrahedron, by triangulating the region on the manifold that
/// its face curves and parts of the complex domain's boundary bound, with samples of a grid
/// inside.
///
/// @param requests the samples asked for, which must be on the arcs by now; those on the boundary
///                 of the complex domain are where the curves cross it
/// @return false if the samples do not suffice: curves cross in the chart, a crossing is missing,
///         or the result's topology is not the plan's
template <class Scalar>
bool mesh_on_manifold(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                      const TetPlan<Scalar>& plan, std::span<const RimRequest<Scalar>> requests,
                      const FaceArcVertices& vertices, const Level<Scalar>& level,
                      const Sampling& sampling, TetTriangles<Scalar>& out);

}  // namespace tensortopo
