// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "extract/surface/cells/mesh_cells.hpp"
#include "tensortopo/extract/level_topology.hpp"

namespace tensortopo {

/// What was proved, in terms of the surface.
/// @param new_id  of each vertex on an edge or face, its number in the surface; -1 without one
template <class Scalar>
LevelTopology proved_topology(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                              std::span<const CellProof<Scalar>> proofs,
                              const CellMeshes<Scalar>& meshes,
                              std::span<const TetMesh::Index> new_id);

}  // namespace tensortopo
