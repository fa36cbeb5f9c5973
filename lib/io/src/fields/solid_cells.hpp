// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fields/merge_points.hpp"
#include "grids/raw_grid.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::detail {

/// For each cell of a grid: whether it belongs to another piece, or is blanked (`vtkGhostType`).
/// Empty if the file does not say.
std::vector<char> ghost_cells(const RawGrid& grid);

/// The numbers of a grid's cells of dimension 3 that are no ghosts.
std::vector<std::size_t> solid_cells(const RawGrid& grid);

/// How many nodes of a solid cell are corners.
std::size_t corners_of(const RawGrid& grid, std::size_t cell);

/// The vertices of a cell's nodes.
std::vector<TetMesh::Index> vertices_of(const RawGrid& grid, std::size_t cell,
                                        const std::vector<TetMesh::Index>& map);
/// The same in a list that is used again.
void vertices_of(const RawGrid& grid, std::size_t cell, const std::vector<TetMesh::Index>& map,
                 std::vector<TetMesh::Index>& vertices);

/// The volume of the cell of these corners; 0 for a type without one.
double cell_volume(const TetMesh& mesh, std::uint8_t vtk_type,
                   std::span<const TetMesh::Index> corners);

}  // namespace tensortopo::detail
