// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// The solid blocks that examples/ solves by finite elements.
enum class Block { compressed, pushed_and_pulled, three_loads, slab };

/// "s1_compress" and so on, as the bundled fields are named.
std::string name_of(Block block);

/// The mesh of a block with a closed-form stand-in for its stress.
///
/// Geometry: a lattice of hexahedra cut in six tetrahedra each, of the block's size in mm; the slab
/// lies on its block along lines of slope 0.45, to which the lattice is sheared. Loads: those of
/// the block, each patch as a grid of Boussinesq's point forces (`boussinesq_stress`) on a half
/// space whose surface lies a quarter of the patch's width above the loaded faces.
/// **No finite-element solution of the block**: the block's sides, clamp and materials play no
/// part.
/// @param tetrahedra  at least so many, about in the proportions of the full mesh
TetMesh block_field(Block block, std::size_t tetrahedra);

}  // namespace tensortopo
