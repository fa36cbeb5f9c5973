// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fields/raw_grid.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::detail {

/// Where the points of each piece went: vertex[piece][point] is a vertex of the mesh.
using VertexMap = std::vector<std::vector<TetMesh::Index>>;

/// Appends the pieces' points, and `tensors` of each piece (or none at all), to an empty mesh,
/// making one of points of different pieces that agree in both. Throws IoError if points agree in
/// position only, if two points of a piece coincide where a third piece meets them, or if a
/// coordinate is not finite.
VertexMap merge_points(const std::vector<RawGrid>& pieces,
                       const std::vector<std::vector<SymmetricTensor<double>>>& tensors,
                       TetMesh& mesh);

}  // namespace tensortopo::detail
