// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// Those between owned tetrahedra and ghosts, ascending.
/// @param told   by owned ones
/// @param heard  from ghosts
void add_messages(const MeshPiece& piece, std::span<const MeshingMessage> messages,
                  std::vector<PieceMessage>& told, std::vector<PieceMessage>& heard);

/// What each piece heard from its ghosts is what their owners told.
///
/// Then all pieces are parts of one extraction. By induction over the steps: what a tetrahedron
/// does in one step depends on its field, on its faces' first samples, and on what it was told
/// before. An owned tetrahedron is told so by owned ones, which did right by induction, and by
/// ghosts, which are compared with their owners' pieces, where they did right by induction, too.
/// @param pieces  surfaces, curves (`PieceSurface`, `PieceCurves`) or seams of these
/// @throws PiecesDiffer with the tetrahedron
template <class Piece>
void require_same_messages(std::span<const Piece> pieces);

}  // namespace tensortopo
