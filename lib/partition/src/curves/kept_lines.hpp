// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What is left of curves where some tetrahedra are taken out.
#pragma once

#include <vector>

#include "tensortopo/partition/piece_curves.hpp"

namespace tensortopo {

/// Takes out lines in ghosts, and vertices that no other line has.
/// @param part  whose `curves.tet` count in the piece's mesh
void keep_owned_lines(const MeshPiece& piece, PieceCurves& part);

/// Gathers the tetrahedra with lines, and those that are unresolved or special; counts in terms of
/// these.
/// @param part  in numbers of the piece's mesh
void gather_cells_of_lines(const MeshPiece& piece, PieceCurves& part);

/// Of each line its component, in the order of the keys of first lines.
std::vector<TetMesh::Index> components_of_lines(const PieceCurves& part);

}  // namespace tensortopo
