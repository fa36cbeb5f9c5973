// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tensortopo/partition/piece_curves.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// Some of the tetrahedra of a mesh as a mesh of their own, and how it numbers what it has.
struct PartNumbers {
  /// Of each of its tetrahedra the id in the whole mesh, and that in the part.
  std::vector<std::array<std::int64_t, 2>> tets;
  /// The same of each of its vertices: at least those of its tetrahedra.
  std::vector<std::array<std::int64_t, 2>> vertices;
};

/// The surface in some of the tetrahedra that a piece owns, as that of a mesh which has no others.
///
/// Law       `merge_pieces` of the result alone, and `certify`, give the surface and the claims about
///           the level in the part's mesh: the triangles in a tetrahedron are a surface of its
///           level, whatever is around it. The triangles are those of the piece, bit for bit, and
///           those of one tetrahedron are in the same order.
/// Vertices  Where the part leaves several fans of triangles at a crossing or isotropic vertex, each
///           but the first gets a copy of the vertex; copies that the piece has become one where the
///           part joins them. Sheets that are joined along an edge between isotropic vertices are so
///           in the part only if that has all tetrahedra between them, on the side of larger modes.
/// Normals   They remain those of the piece: at the part's border they are means over tetrahedra
///           that the part does not have.
/// @throws std::invalid_argument if ids repeat, if the piece does not own one of the tetrahedra, or
///         if a vertex of one has no number
PieceSurface restrict_piece(const PieceSurface& piece, const PartNumbers& numbers);

/// The degenerate curves in some of the tetrahedra that a piece owns, as those of a mesh which has no
/// others.
///
/// Law       `merge_curve_pieces` of the result alone, and `certify`, give the curves and the claims
///           about them in the part's mesh. Lines and vertices are those of the piece, bit for bit.
/// Vertices  `separation` and `residual` remain those of the piece: at the part's border they depend on
///           lines that the part does not have.
/// @throws std::invalid_argument as above
PieceCurves restrict_piece(const PieceCurves& piece, const PartNumbers& numbers);

}  // namespace tensortopo
