// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fields/merge_points.hpp"
#include "fields/tensor_array.hpp"
#include "grids/raw_grid.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo::detail {

/// Of each piece's cells the material, as a number from 0; none if means are taken over all.
/// Throws IoError, also if nobody says whether means are taken over several materials.
using Materials = std::vector<std::vector<std::size_t>>;
Materials materials_of(const std::vector<RawGrid>& pieces, const ReadOptions& options);

/// Makes vertices between cells of several materials one for each material: the grids' cells get
/// points of their own, and the mesh their vertices. Returns how many were added.
std::size_t separate_materials(std::vector<RawGrid>& pieces, VertexMap& map,
                               const Materials& materials, TetMesh& mesh);

/// Gives each vertex of the mesh the mean of the tensors that cells around it have for it. Returns
/// how many got one. Throws IoError.
/// @param tensors  of each piece's cells, as `choice` says: one each, one for each node, or several
std::size_t average_cells(const std::vector<RawGrid>& pieces, const VertexMap& map,
                          const std::vector<std::vector<SymmetricTensor<double>>>& tensors,
                          const TensorChoice& choice, MeanWeights weights, TetMesh& mesh);

}  // namespace tensortopo::detail
