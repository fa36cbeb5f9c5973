// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "baselines/triangle_soup.hpp"

namespace tensortopo::baselines {

/// The neutral surface in one tetrahedron by its parameterization (see `NeutralMap`).
///
/// The sphere of directions, modulo antipodes, is cut into triangles, with the singularities among
/// their corners (each is blown up to the line of its places), until signs of Bernstein
/// coefficients show that a triangle maps to the outside, or the weights' rational Bezier net that
/// its image is within `tolerance` of a plane and its part inside the tetrahedron bounded by curves
/// as close to lines. These parts are clipped by the four weights, whose zeros on the segments are
/// found exactly, and mapped. Vertices on the tetrahedron's edges are the same, bit by bit, in all
/// tetrahedra around; those on faces are each tetrahedron's own.
/// @param corners    of a positively oriented tetrahedron, with tensors of one common scale
/// @param tolerance  in units of the longest edge
/// @return false, and nothing is added, if that takes too many triangles, or the field is in
///         special position: of rank below 4, or with one singularity
bool add_hybrid(const std::array<FieldPoint, 4>& corners, SurfaceMesh::Index tet, double tolerance,
                std::vector<SoupTriangle>& out);

}  // namespace tensortopo::baselines
