// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "random_fields.hpp"

namespace tensortopo::test {

/// What the vertices of a small mesh have in common, or lack.
enum class MeshKind {
  ones,             ///< entries -1, 0, 1: ties, equal tensors and low ranks everywhere
  small_integers,   ///< entries from -2 to 2
  sparse,           ///< most entries zero
  mirrored,         ///< symmetric about the two middle planes x = const and y = const
  plane_stress,     ///< z is an eigenvector throughout, its eigenvalue 0 or 1
  antiplane,        ///< at z = 0 nothing but yz and xz
  special_tensors,  ///< normal tensors, and among them zeros, degenerate and neutral ones
};

const std::vector<MeshKind>& all_mesh_kinds();
std::string name_of(MeshKind kind);

/// A box of 1 to 8 unit cubes, six tetrahedra each, with random tensors of the kind.
///
/// Where single tetrahedra of a stratum have neighbours, what is special meets: levels along edges
/// that end at an isotropic vertex, lines of saddles next to symmetry planes.
TetMesh special_mesh(MeshKind kind, Random& random);

}  // namespace tensortopo::test
