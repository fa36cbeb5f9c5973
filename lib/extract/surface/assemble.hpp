// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "extract/surface/boundary/active_cells.hpp"
#include "extract/surface/cells/mesh_cells.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo {

/// Puts the patches together: numbers the vertices inside tetrahedra, drops what nothing uses, and
/// says what is known at each vertex. Its arguments are given back on the way.
template <class Scalar>
Extraction assemble(const SurfaceInput<Scalar>& input, const VertexSides& sides, ActiveCells active,
                    std::vector<CellProof<Scalar>> proofs, CellMeshes<Scalar> meshes);

}  // namespace tensortopo
