// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo {

/// Where an edge of a `LevelTopology` was before it was renumbered.
struct MovedEdge {
  std::size_t from = 0;
  bool is_reversed = false;  ///< its vertices are in the other order, and so are its crossings
};

/// Gives the vertices and tetrahedra of the mesh other numbers in what an extraction says of them:
/// v becomes vertices[v], t becomes tets[t]. Vertices and triangles of the surface keep theirs;
/// lists that are in the order of the mesh's numbers are put in their new order.
///
/// Law       With the inverse permutations all is again what it was, bit for bit.
/// @return   of each edge of the topology, in the new order, where it was
std::vector<MovedEdge> renumber(Extraction& extraction, std::span<const TetMesh::Index> vertices,
                                std::span<const TetMesh::Index> tets);

}  // namespace tensortopo
