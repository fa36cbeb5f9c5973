// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "distances/layers.hpp"
#include "extract/level/level.hpp"
#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/quadric/quadric_form.hpp"

namespace tensortopo {

/// Bounds on the distance between the triangles and the level, both ways.
///
/// Each vertex is moved by its reach, forwards and backwards, along the gradient of the mode within
/// its carrier; the moved triangles stay in the tetrahedron. If the level does not meet either of
/// the two, and they are on different sides of it, it meets every segment between them: each point
/// of the triangle is within the reach of the level. The segments over an arc of a face lie in the
/// face and hold the arc, as its ends do not leave their edges and no other crossing is near; so
/// what the segments over a sheet hold has degree one over the level's sheet, and covers it: each
/// point of the level is within the reach of the triangles, too. (For a sheet that meets no edge of
/// the tetrahedron see `uncovered_closed_loops`.) Around isotropic vertices both are cones:
/// what holds of the curve on the opposite face holds, shrunk, of all of it, and tips stay in
/// place.
///
/// Where that is not proved, see `coarse_bounds`.
///
/// @param triangles  those of the surface that the claim is about
/// @param wanted     there: a distance that is worth some time; 0: none
DistanceClaim prove_distance(const TetMesh& mesh, const SurfaceMesh& surface,
                             std::span<const std::size_t> triangles, const LevelTopology& topology,
                             const ScaledField<double>& field, const Level<double>& level,
                             double wanted = 0);

/// The same of an invariant's level: moved along the gradient of its quadratic form, which is
/// also what a triangle's side is told by: the polar forms of its corners are the coefficients
/// there.
DistanceClaim prove_distance(const TetMesh& mesh, const SurfaceMesh& surface,
                             std::span<const std::size_t> triangles, const LevelTopology& topology,
                             const QuadraticLevel& level);

/// Where vertices are moved to by their reaches. The arguments have to outlive it.
MovedPlaces moved_places(const TetMesh& mesh, const SurfaceMesh& surface,
                         std::span<const int> reach, const ScaledField<double>& field,
                         const Level<double>& level);
MovedPlaces moved_places(const TetMesh& mesh, const SurfaceMesh& surface,
                         std::span<const int> reach, const QuadraticLevel& level);

}  // namespace tensortopo
