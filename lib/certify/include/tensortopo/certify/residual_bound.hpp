// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/quadric/invariant_level.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// An upper bound, proved, of |mode - mu| over all vertices of a surface: at the doubles that are
/// their coordinates, in the linear field of each tetrahedron that has a triangle at the vertex,
/// continued beyond it where rounding puts the vertex outside. From doubles with a running error
/// bound. Vertices between isotropic vertices of the mesh are not counted, as no mode is there; where
/// rounding leaves room for that, and of tetrahedra without volume, the bound is 1 + |mu|.
/// @return 0 for no vertices
double residual_bound(const TetMesh& mesh, const ModeValue& mode, const SurfaceMesh& surface);

/// The same of another invariant and its value, in units of the invariant; infinite where nothing
/// can be said.
double residual_bound(const TetMesh& mesh, const InvariantLevel& level, const SurfaceMesh& surface);

}  // namespace tensortopo
