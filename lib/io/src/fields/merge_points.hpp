// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "grids/raw_grid.hpp"
#include "tensortopo/io/read_mesh.hpp"
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

/// Makes one of vertices of a mesh in the same place: those whose tensors are equal (all, if the
/// mesh has no tensors yet), or those around which the same materials are, with the mean of their
/// tensors. Vertices get new numbers, in the map too. Returns how many are gone. Throws IoError.
/// @param mean       the weights; empty: equal tensors only
/// @param materials  of the pieces' cells, or none
std::size_t merge_vertices(const std::vector<RawGrid>& pieces, VertexMap& map,
                           const std::vector<std::vector<std::size_t>>& materials,
                           std::optional<MeanWeights> mean, TetMesh& mesh);

}  // namespace tensortopo::detail
