// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fields/cells_where.hpp"
#include "fields/merge_points.hpp"
#include "grids/raw_grid.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo::detail {

/// Appends the tetrahedra of the pieces, and those of cells that are split, to a mesh that has its
/// points and tensors. Orients every tetrahedron. Throws IoError.
/// @param selection  which cells are taken; none for all
void assemble_cells(const std::vector<RawGrid>& pieces, const VertexMap& map,
                    const CellSelection& selection, QuadraticCells quadratic,
                    const ReadOptions& options, TetMesh& mesh, ReadReport& report);

}  // namespace tensortopo::detail
